#include "color/color.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <mutex>

#include "color/implementation.h"
#include "core/log.h"
#include "core/paths.h"

namespace tyndall {
namespace {

constexpr const char* kSrgbTextureNames[] = {"srgb_texture", "srgb_tx", "sRGB - Texture", "Utility - sRGB - Texture",
                                             "sRGB"};
constexpr const char* kLinearRec709Names[] = {
    "lin_rec709",     "lin_rec709_srgb", "lin_srgb", "Linear Rec.709 (sRGB)", "Utility - Linear - sRGB",
    "Linear Rec.709", "Linear"};

std::filesystem::path chosen_file(const std::filesystem::path& file) {
    if (!file.empty()) return file;
    const char* wanted = std::getenv("OCIO");
    if (wanted && *wanted) return wanted;
    return paths::root() / "config" / "color" / "tyndall.ocio";
}

/// OpenColorIO writes warnings to stderr by itself; they belong in the log.
void route_log_once() {
    static std::once_flag done;
    std::call_once(done, [] {
        OCIO::SetLoggingFunction([](const char* message) {
            std::string_view text(message);
            while (text.ends_with('\n')) text.remove_suffix(1);
            log::debug("{}", text);
        });
    });
}

std::string joined(const std::vector<std::string>& names) {
    std::string out;
    for (const std::string& name : names) out += (out.empty() ? "" : ", ") + name;
    return out;
}

/// "unknown view 'X'", with the list and the nearest of them.
[[noreturn]] void unknown(const std::filesystem::path& file, std::string_view what, std::string_view name,
                          const std::vector<std::string>& known, std::string_view where = {}) {
    throw Error(Diagnostic{{file.string()},
                           fmt::format("unknown {} '{}'{}", what, name, where),
                           "one of: " + joined(known),
                           nearest_name(name, known)});
}

/// The first of the usual names that the configuration knows, or empty.
std::string first_known(const OCIO::Config& config, std::span<const char* const> names) {
    for (const char* name : names)
        if (const auto space = config.getColorSpace(name)) return space->getName();
    return {};
}

}  // namespace

ColorConfig::ColorConfig(const std::filesystem::path& file) : self_(std::make_unique<Implementation>()) {
    route_log_once();
    self_->file = chosen_file(file);
    const std::string name = self_->file.string();
    if (!std::filesystem::is_regular_file(self_->file))
        throw Error(Diagnostic{{name}, "no such file", "an OpenColorIO configuration", {}});
    self_->guarded("not a usable OpenColorIO configuration", [&] {
        self_->config = OCIO::Config::CreateFromFile(name.c_str());
        self_->config->validate();
    });
    if (!self_->config->hasRole(OCIO::ROLE_SCENE_LINEAR))
        throw Error(Diagnostic{{name}, "the configuration has no role scene_linear", {}, {}});
    if (displays().empty() || views().empty())
        throw Error(Diagnostic{{name}, "the configuration has no display with a view", {}, {}});
}

ColorConfig::~ColorConfig() = default;
ColorConfig::ColorConfig(ColorConfig&&) noexcept = default;
ColorConfig& ColorConfig::operator=(ColorConfig&&) noexcept = default;

const std::filesystem::path& ColorConfig::file() const {
    return self_->file;
}

std::string ColorConfig::working_space() const {
    return self_->config->getColorSpace(OCIO::ROLE_SCENE_LINEAR)->getName();
}

std::vector<std::string> ColorConfig::color_spaces() const {
    std::vector<std::string> names;
    for (int i = 0; i < self_->config->getNumColorSpaces(); ++i)
        names.emplace_back(self_->config->getColorSpaceNameByIndex(i));
    return names;
}

std::vector<std::string> ColorConfig::displays() const {
    std::vector<std::string> names;
    for (int i = 0; i < self_->config->getNumDisplays(); ++i) names.emplace_back(self_->config->getDisplay(i));
    return names;
}

std::vector<std::string> ColorConfig::views(std::string_view display) const {
    const std::string on(display.empty() ? default_display() : display);
    const std::vector<std::string> known = displays();
    if (std::ranges::find(known, on) == known.end()) unknown(self_->file, "display", on, known);
    std::vector<std::string> names;
    for (int i = 0; i < self_->config->getNumViews(on.c_str()); ++i)
        names.emplace_back(self_->config->getView(on.c_str(), i));
    return names;
}

std::string ColorConfig::default_display() const {
    return self_->config->getDefaultDisplay();
}

std::string ColorConfig::default_view(std::string_view display) const {
    return self_->config->getDefaultView(std::string(display.empty() ? default_display() : display).c_str());
}

std::string ColorConfig::space_of_file(const std::filesystem::path& file, std::string_view wanted) const {
    if (!wanted.empty()) return wanted == "data" ? "data" : self_->space(wanted);
    return self_->guarded("file rules", [&] {
        const std::string name = file.string();
        if (self_->config->filepathOnlyMatchesDefaultRule(name.c_str())) {
            std::string extension = file.extension().string();
            std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
            const bool linear = extension == ".exr" || extension == ".hdr";
            const std::string usual = linear ? first_known(*self_->config, kLinearRec709Names)
                                             : first_known(*self_->config, kSrgbTextureNames);
            if (!usual.empty()) return usual;
        }
        return self_->space(self_->config->getColorSpaceFromFilepath(name.c_str()));
    });
}

std::string ColorConfig::srgb_texture_space() const {
    const std::string found = first_known(*self_->config, kSrgbTextureNames);
    if (found.empty())
        throw Error(Diagnostic{{self_->file.string()},
                               "the configuration has no colour space of sRGB textures",
                               "a space with the name or alias 'srgb_texture'",
                               {}});
    return found;
}

bool ColorConfig::is_data(std::string_view space) const {
    const std::string name = self_->space(space);
    return name.empty() || space == "data" || self_->config->getColorSpace(name.c_str())->isData();
}

bool ColorConfig::decodes_as_srgb(std::string_view space) const {
    if (is_data(space)) return false;
    // Saturated colours tell other primaries, greys another curve.
    std::vector<float> encoded{0.02f, 0.02f, 0.02f, 0.2f, 0.2f, 0.2f, 0.5f, 0.7f, 0.9f,
                               1.0f,  0.0f,  0.0f,  0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f};
    std::vector<float> decoded = encoded;
    convert(decoded, space, working_space());
    return std::ranges::equal(encoded, decoded, [](float v, float d) {
        return std::abs((v > 0.04045f ? std::pow((v + 0.055f) / 1.055f, 2.4f) : v / 12.92f) - d) < 2e-4f;
    });
}

ColorConfig::Implementation::Target ColorConfig::Implementation::target(std::string_view display,
                                                                        std::string_view view) const {
    Target found{std::string(display.empty() ? config->getDefaultDisplay() : display), std::string(view)};
    const auto list = [](int count, auto&& name_at) {
        std::vector<std::string> names;
        for (int i = 0; i < count; ++i) names.emplace_back(name_at(i));
        return names;
    };
    const char* on = found.display.c_str();
    const auto displays = list(config->getNumDisplays(), [&](int i) { return config->getDisplay(i); });
    if (std::ranges::find(displays, found.display) == displays.end()) unknown(file, "display", display, displays);
    const auto views = list(config->getNumViews(on), [&](int i) { return config->getView(on, i); });
    if (found.view.empty()) found.view = config->getDefaultView(on);
    if (std::ranges::find(views, found.view) == views.end())
        unknown(file, "view", found.view, views, " of the display '" + found.display + "'");
    return found;
}

std::string ColorConfig::Implementation::space(std::string_view name) const {
    const std::string wanted(name);
    if (const auto found = config->getColorSpace(wanted.c_str())) return found->getName();
    if (name == "data") return {};
    std::vector<std::string> known{"data"};
    for (int i = 0; i < config->getNumColorSpaces(); ++i) known.emplace_back(config->getColorSpaceNameByIndex(i));
    unknown(file, "colour space", name, known);
}

}  // namespace tyndall
