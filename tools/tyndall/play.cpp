#include "app/player.h"
#include "commands.h"

namespace tyndall {
namespace {

struct PlayOptions {
    SceneOptions scene;
    std::string file = "assets/chapel/chapel.json";
    std::string size = "1280x720";
    std::string screenshot;
    float render_scale = 1.0f;
    int frames = 0;
    bool fullscreen = false, no_vsync = false, watch = false;
};

int play(const PlayOptions& options) {
    PlayerOptions player;
    player.scene = options.file;
    player.changes = options.scene.changes();
    player.ocio = options.scene.ocio;
    player.camera = options.scene.camera;
    player.view = options.scene.view;
    player.size = parse_size(options.size);
    player.render_scale = options.render_scale;
    player.fullscreen = options.fullscreen;
    player.vsync = !options.no_vsync;
    player.watch = options.watch;
    player.frames = options.frames;
    player.screenshot = options.screenshot;
    Player(player).run();
    return 0;
}

}  // namespace

void add_play(CLI::App& app, Command& command) {
    auto options = std::make_shared<PlayOptions>();
    CLI::App* sub = app.add_subcommand("play", "Walk through a scene in a window");
    sub->add_option("scene", options->file, "Scene file")->capture_default_str();
    sub->add_option("--size", options->size, "WIDTHxHEIGHT of the window")->capture_default_str();
    sub->add_option("--render-scale", options->render_scale,
                    "Render this much of the window's pixels in each direction")
        ->check(CLI::Range(0.1, 2.0));
    sub->add_flag("--fullscreen", options->fullscreen, "Fill the monitor");
    sub->add_flag("--no-vsync", options->no_vsync, "Do not wait for the monitor");
    sub->add_flag(
        "--watch", options->watch,
        "Rebuild modules and reload modules, shaders, scenes, textures and OCIO configurations when they are saved");
    sub->add_option("--frames", options->frames, "Quit after so many frames at a fixed clock")
        ->check(CLI::Range(0, 1000000));
    sub->add_option("--screenshot", options->screenshot, "Write the last picture to this PNG");
    options->scene.add_to(*sub);
    sub->footer("Keys and speeds: config/input.json.");
    sub->callback([options, &command] { command = [options] { return play(*options); }; });
}

}  // namespace tyndall
