#include "texture_space/lobe_blurs.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

namespace tyndall::skin {
namespace {

/// Share of the texels that lean from which on taps are put between columns.
constexpr float kLeaning = 0.02f;

gpu::Texture make_kernels() {
    std::vector<float> all;
    for (int radius = 1; radius <= kMaxRadius; ++radius) {
        const std::vector<float> bases = kernel_bases(radius);
        all.insert(all.end(), bases.begin(), bases.end());
    }
    gpu::Texture texture({.format = gpu::Format::r32f, .width = kKernelColumns, .height = kMaxRadius},
                         "skin.texture_space.kernels");
    texture.upload(0, 0, all.data());
    return texture;
}

/// Texels a metre that all but a fiftieth of the texels stay below, over the mean.
float densest_of(const Atlas& atlas) {
    std::vector<float> along;
    for (const AtlasTexel& texel : atlas.texels) along.push_back(std::max(texel.steps.along_u, texel.steps.along_v));
    if (along.empty()) return 1.0f;
    const auto at = along.begin() + std::ptrdiff_t(0.98 * double(along.size()));
    std::ranges::nth_element(along, at);
    return *at * atlas.texel_m;
}

const gpu::Program& use(gpu::ShaderLibrary& shaders, std::string_view shader, std::vector<std::string> defines = {}) {
    const gpu::Program& program = shaders.program({.name = fmt::format("skin.texture_space.{}", shader),
                                                   .compute = fmt::format("skin/texture_space/{}.comp", shader),
                                                   .defines = std::move(defines)});
    program.use();
    return program;
}

}  // namespace

void fill_gutters(gpu::ShaderLibrary& shaders, const gpu::Texture& map, const GpuAtlas& atlas, Gutters which) {
    const int begin = which == Gutters::near ? atlas.far_gutters : 0;
    const int end = atlas.gutters + (which == Gutters::near ? atlas.padding : 0);
    const gpu::Program& program = use(shaders, "fill");
    program.image("map", map, 0, true);
    bind_list(program, "taps", atlas.taps);
    bind_list(program, "weights", atlas.weights);
    bind_list(program, "gutter_charts", atlas.gutter_charts);
    program.set("list_begin", unsigned(begin));
    program.set("list_size", unsigned(end));
    dispatch_list(end - begin);
}

LobeBlurs::LobeBlurs(const std::array<Atlas, kLevels>& atlases) : kernels_(make_kernels()) {
    for (const Atlas& atlas : atlases) {
        if (!levels_.empty() && !atlas.usable()) break;
        Level level;
        level.atlas = GpuAtlas(atlas, levels_.empty());
        level.light = level.atlas.make_map("skin.texture_space.light");
        level.half = level.atlas.make_map("skin.texture_space.half");
        level.total = level.atlas.make_map("skin.texture_space.total");
        const ChunkSet all = AtlasChunks(atlas).all();
        level.covered.update(level.atlas, all, false);
        level.with_gutters.update(level.atlas, all, true);
        levels_.push_back(std::move(level));
    }
    map_ = {atlases[0].texel_m, densest_of(atlases[0]), int(levels_.size())};
    leans_ = atlases[0].leaning > kLeaning;
}

void LobeBlurs::choose(const ChunkSet& set) {
    levels_[0].covered.update(levels_[0].atlas, set, false);
    levels_[0].with_gutters.update(levels_[0].atlas, set, true);
}

void LobeBlurs::run(gpu::ShaderLibrary& shaders, const physics::DiffusionProfile& profile) {
    if (planned_ != profile) {
        plan_ = plan_lobes(profile, map_);
        planned_ = profile;
    }
    for (Level& level : levels_) level.begun = false;
    int level = 0;
    glm::vec3 sharp = plan_.sharp;
    for (const LobeBlur& lobe : plan_.blurs) {
        for (; level < lobe.level; ++level) {
            if (level == 0 && sharp != glm::vec3(0.0f)) grow(shaders, 0, std::exchange(sharp, glm::vec3(0.0f)));
            shrink(shaders, level + 1);
        }
        blur(shaders, lobe, std::exchange(sharp, glm::vec3(0.0f)));
    }
    for (; level > 0; --level) {
        fill_gutters(shaders, levels_[size_t(level)].total, levels_[size_t(level)].atlas, Gutters::near);
        grow(shaders, level - 1, glm::vec3(0.0f));
    }
    if (plan_.blurs.empty()) grow(shaders, 0, sharp);
    fill_gutters(shaders, levels_[0].total, levels_[0].atlas, Gutters::near);
}

void LobeBlurs::shrink(gpu::ShaderLibrary& shaders, int to) const {
    const Level &fine = levels_[size_t(to) - 1], &level = levels_[size_t(to)];
    fill_gutters(shaders, fine.light, fine.atlas, Gutters::near);
    const gpu::Program& program = use(shaders, "shrink");
    program.image("fine", fine.light, 0, false);
    program.image("map", level.light, 0, true);
    bind_list(program, "steps", level.atlas.steps);
    bind_list(program, "charts", level.atlas.charts);
    program.set("list_size", unsigned(level.atlas.covered));
    program.set("gutter", kGutterTexels);
    dispatch_list(level.atlas.covered);
}

void LobeBlurs::blur(gpu::ShaderLibrary& shaders, const LobeBlur& lobe, const glm::vec3& sharp) {
    Level& level = levels_[size_t(lobe.level)];
    fill_gutters(shaders, level.light, level.atlas, Gutters::all);
    half_blur(shaders, lobe, sharp, true);
    half_blur(shaders, lobe, sharp, false);
    level.begun = true;
}

void LobeBlurs::half_blur(gpu::ShaderLibrary& shaders, const LobeBlur& lobe, const glm::vec3& sharp,
                          bool along_u) const {
    const Level& level = levels_[size_t(lobe.level)];
    std::vector<std::string> defines{"CHUNKS"};
    if (along_u) defines.emplace_back("ALONG_U");
    if (leans_) defines.emplace_back("LEANS");
    const gpu::Program& program = use(shaders, "blur", std::move(defines));
    program.image("map", level.light, 0, true);
    program.image("other", level.half, 0, true);
    bind_list(program, "steps", level.atlas.steps);
    program.texture("kernels", kernels_, {.filter = gpu::Filter::linear});
    program.set("variance", lobe.variance_m2);
    program.set("less", lobe.less_texels2);
    program.set("most_taps", lobe.radius);
    if (!along_u) {
        program.image("total", level.total, 0, true);
        program.set("weight", lobe.weight);
        program.set("sharp", sharp);
        program.set("keeps", level.begun ? 1.0f : 0.0f);
    }
    (along_u ? level.with_gutters : level.covered).dispatch(program);
}

/// Adds the next level's total to this one's, and a share of the light as it is.
void LobeBlurs::grow(gpu::ShaderLibrary& shaders, int to, const glm::vec3& sharp) {
    Level& level = levels_[size_t(to)];
    const bool has_coarse = size_t(to) + 1 < levels_.size() && levels_[size_t(to) + 1].begun;
    const gpu::Program& program = use(shaders, "grow", {"CHUNKS"});
    program.image("total", level.total, 0, true);
    program.image("map", level.light, 0, false);
    bind_list(program, "steps", level.atlas.steps);
    bind_list(program, "charts", level.atlas.charts);
    program.texture("coarse", has_coarse ? levels_[size_t(to) + 1].total : level.light,
                    {.filter = gpu::Filter::linear});
    program.set("coarse_share", has_coarse ? 1.0f : 0.0f);
    program.set("sharp", sharp);
    program.set("keeps", level.begun ? 1.0f : 0.0f);
    program.set("gutter", float(kGutterTexels));
    level.covered.dispatch(program);
    level.begun = true;
}

size_t LobeBlurs::bytes() const {
    size_t texels = 0;
    for (const Level& level : levels_) texels += size_t(level.atlas.extent) * size_t(level.atlas.extent);
    return texels * 3 * gpu::bytes_per_texel(gpu::Format::rgba32f);
}

}  // namespace tyndall::skin
