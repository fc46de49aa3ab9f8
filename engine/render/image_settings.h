#pragma once
/// How the finished picture is made: "image" under "render" in scene files.

#include "ecs/description.h"

namespace tyndall {

enum class Antialiasing { none, fxaa };

struct ImageSettings {
    static constexpr std::string_view kName = "image";
    Antialiasing antialiasing = Antialiasing::fxaa;
    bool dither = true;
};

inline void describe(StructBuilder<ImageSettings>& d) {
    d.doc("How the finished picture is made.");
    d.field("antialiasing", &ImageSettings::antialiasing,
            "none: as rendered; fxaa: jagged edges are smoothed in the displayed picture.", {"none", "fxaa"});
    d.field("dither", &ImageSettings::dither,
            "Noise of at most one step of the display's 8 bits, so that gradients show no bands.");
}

}  // namespace tyndall
