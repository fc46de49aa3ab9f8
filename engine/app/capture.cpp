#include "app/capture.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/build_info.h"
#include "core/paths.h"
#include "image/image_io.h"
#include "platform/context.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

Json settings_json(const Settings& settings) {
    Json all = Json::object();
    for (const std::string& name : settings.names())
        all[name] = Json::parse(component_to_json(*settings.type(name), settings.find(name)));
    return all;
}

Json modules_json(const ModuleManager& modules) {
    Json all = Json::object();
    for (const ModuleReport& report : modules.reports())
        if (report.state == ModuleState::loaded || report.state == ModuleState::outdated)
            all[report.name] = report.version;
    return all;
}

Json record(Engine& engine, const platform::GlInfo& gl, const Shot& shot, const Assignments& changes) {
    Json json;
    json["scene"] = fs::relative(engine.scene_path(), paths::root()).generic_string();
    json["changes"] = Json::array();
    for (const auto& [pointer, value] : changes) json["changes"].push_back(pointer + "=" + value);
    json["camera"] = shot.camera;
    json["size"] = {shot.size.x, shot.size.y};
    json["supersample"] = shot.supersample;
    json["frames"] = shot.frames;
    json["step_s"] = shot.step_s;
    json["path"] = engine.options().path;
    const std::string display =
        engine.options().display.empty() ? engine.color().default_display() : engine.options().display;
    json["display"] = display;
    json["view"] = engine.options().view.empty() ? engine.color().default_view(display) : engine.options().view;
    json["ocio"] = engine.color().file().filename().string();
    json["settings"] = settings_json(engine.settings());
    json["modules"] = modules_json(engine.modules());
    json["tyndall"] = build_info().version;
    json["build"] = build_info().revision;
    json["gl"] = {{"vendor", gl.vendor}, {"renderer", gl.renderer}, {"version", gl.version}};
    return json;
}

}  // namespace

Image read_back(const gpu::Texture& texture) {
    const std::vector<glm::vec4> texels = texture.read();
    Image image(texture.desc().width, texture.desc().height, 3, Image::Type::f32);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const glm::vec4& texel =
                texels[static_cast<size_t>(image.height - 1 - y) * static_cast<size_t>(image.width) +
                       static_cast<size_t>(x)];
            image.at(x, y, 0) = texel.x;
            image.at(x, y, 1) = texel.y;
            image.at(x, y, 2) = texel.z;
        }
    return image;
}

CapturedPicture take(Engine& engine, const Shot& shot) {
    engine.select_camera(shot.camera);
    engine.renderer().show(shot.target);
    engine.restart_clock();
    if (engine.extract().cameras.empty())
        throw Error(Diagnostic{{engine.scene_path().string()},
                               "the scene has no camera",
                               "an entity with a camera, or a glTF file with one"});
    const glm::ivec2 size = shot.size * shot.supersample;
    for (int i = 0; i < shot.frames; ++i) engine.frame(i == 0 ? 0.0 : shot.step_s, size);
    CapturedPicture picture;
    const gpu::Texture* radiance = engine.renderer().target(shot.target.empty() ? "radiance" : shot.target);
    const gpu::Texture* display = engine.renderer().target("display");
    if (!radiance || !display) throw Error("no picture was rendered: " + engine.problems());
    picture.radiance = box_downsample(read_back(*radiance), shot.supersample);
    picture.display = to_u8(box_downsample(read_back(*display), shot.supersample));
    return picture;
}

void write(Engine& engine, const platform::GlInfo& gl, const Shot& shot, const Assignments& changes,
           const CapturedPicture& picture, const fs::path& stem, const PictureFiles& files) {
    fs::create_directories(stem.parent_path());
    const auto with = [&](const char* extension) { return fs::path(stem.string() + extension); };
    const Json json = record(engine, gl, shot, changes);
    if (files.png) save_png(with(".png"), picture.display);
    if (files.exr) save_exr(with(".exr"), picture.radiance);
    paths::write_file_atomically(with(".json"), json.dump(2) + "\n");
}

}  // namespace tyndall
