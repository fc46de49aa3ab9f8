#include <charconv>

#include "commands.h"
#include "core/error.h"

namespace tyndall {

glm::ivec2 parse_size(const std::string& text) {
    glm::ivec2 size{0};
    const char* end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.x);
    if (width.ec == std::errc() && width.ptr != end && *width.ptr == 'x') {
        const auto height = std::from_chars(width.ptr + 1, end, size.y);
        if (height.ec == std::errc() && height.ptr == end && size.x > 0 && size.y > 0 && size.x <= 16384 &&
            size.y <= 16384)
            return size;
    }
    throw Error("'" + text + "' is no size (expected WIDTHxHEIGHT, each 1 to 16384, such as 1280x720)");
}

void SceneOptions::add_scene_to(CLI::App& command) {
    command
        .add_option("--set", set,
                    "Change the scene before it is loaded: /json/pointer=value; /entities/NAME/... names an entity")
        ->type_name("/POINTER=VALUE")
        ->allow_extra_args(false);
    command.add_option("--camera", camera, "Entity with a camera to look through");
    command.add_option("--ocio", ocio, "OpenColorIO configuration; otherwise $OCIO or config/color/tyndall.ocio");
}

void SceneOptions::add_to(CLI::App& command) {
    add_scene_to(command);
    command.add_option("--path", path, "Render path: deferred or light_pre_pass");
    command.add_option(
        "--view", view,
        "Show a target of the frame in place of the picture (scene_depth, gbuffer_normal, light_diffuse, ...)");
}

Assignments SceneOptions::changes() const {
    Assignments all;
    for (const std::string& text : set) all.push_back(split_assignment(text));
    if (!path.empty()) all.emplace_back("/render/path", "\"" + path + "\"");
    return all;
}

}  // namespace tyndall
