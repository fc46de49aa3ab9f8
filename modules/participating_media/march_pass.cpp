#include "march_pass.h"

#include "physics/blue_noise.h"

namespace tyndall::participating_media {
namespace {

gpu::Texture make_blue_noise() {
    const std::vector<float> mask = physics::blue_noise_mask();
    gpu::Texture texture(
        {.format = gpu::Format::r32f, .width = physics::kBlueNoiseSize, .height = physics::kBlueNoiseSize},
        "participating_media.blue_noise");
    texture.upload(0, 0, mask.data());
    return texture;
}

}  // namespace

void MarchPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::media)
        .reads("scene_depth", "where rays end")
        .writes("media_in_scatter",
                {.format = gpu::Format::rgba32f, .scale = settings_.resolution == Resolution::half ? 0.5f : 1.0f},
                "single-scattered radiance between the eye and the surface, and the distance marched");
}

void MarchPass::execute(PassContext& context) {
    Frame& frame = context.frame();
    if (blue_noise_.name() == 0) blue_noise_ = make_blue_noise();
    const gpu::Program& program =
        frame.shaders.program({.name = "participating_media.march", .fragment = "participating_media/march.frag"});
    context.bind_targets();
    program.use();
    bind_frame(program, frame);
    frame.seams.bind(Seam::light_transmittance, program, context);
    media_->bind(program, frame.scene, settings_.enabled);
    program.texture("scene_depth", context.texture("scene_depth"), {.filter = gpu::Filter::nearest});
    program.texture("blue_noise", blue_noise_,
                    {.filter = gpu::Filter::nearest, .wrap_u = gpu::Wrap::repeat, .wrap_v = gpu::Wrap::repeat});
    program.set("steps", settings_.steps);
    program.set("jitter", settings_.jitter ? 1 : 0);
    program.set("light_count", static_cast<int>(frame.scene.lights.size()));
    program.set("pixel_step", settings_.resolution == Resolution::half ? 2 : 1);
    gpu::draw_fullscreen();
}

}  // namespace tyndall::participating_media
