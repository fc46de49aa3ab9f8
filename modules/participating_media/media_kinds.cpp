#include "media_kinds.h"

#include <algorithm>
#include <set>

namespace tyndall::participating_media {
namespace {

void add_kinds(std::set<std::string>& kinds, const DensityField& density) {
    if (std::holds_alternative<NoiseDensity>(density)) {
        kinds.emplace("MEDIA_NOISE");
    } else if (std::holds_alternative<GridDensity>(density)) {
        kinds.emplace("MEDIA_GRIDS");
    } else if (std::holds_alternative<GradientDensity>(density)) {
        kinds.emplace("MEDIA_RAMPS");
    } else if (const auto* product = std::get_if<ProductDensity>(&density)) {
        kinds.emplace("MEDIA_PRODUCTS");
        add_kinds(kinds, *product->base);
    } else if (std::holds_alternative<HeightDensity>(density)) {
        kinds.emplace("MEDIA_HEIGHT");
    } else if (std::holds_alternative<BlobDensity>(density)) {
        kinds.emplace("MEDIA_BLOBS");
    }
}

/// Along a line.
bool has_closed_form(const Medium& medium) {
    const DensityField& density = medium.density;
    return std::holds_alternative<ConstantDensity>(density) || std::holds_alternative<HeightDensity>(density) ||
           std::holds_alternative<BlobDensity>(density);
}

bool is_even(const Medium& medium) {
    return std::holds_alternative<ConstantDensity>(medium.density);
}

}  // namespace

std::string media_kinds(const std::vector<Medium>& media, const LightKinds& lights) {
    std::set<std::string> kinds;
    for (const Medium& medium : media) {
        add_kinds(kinds, medium.density);
        if (medium.shape == MediumShape::ellipsoid) kinds.emplace("MEDIA_ELLIPSOIDS");
    }
    if (lights.marched) kinds.emplace("MEDIA_SHADOWS_MARCHED");
    if (lights.opacity) kinds.emplace("MEDIA_SHADOWS_OPACITY");
    if (lights.fourier) kinds.emplace("MEDIA_SHADOWS_FOURIER");
    if (lights.clipmap) kinds.emplace("MEDIA_SHADOWS_CLIPMAP");
    if (lights.surface_glow) kinds.emplace("MEDIA_SURFACE_GLOW");
    if (std::ranges::any_of(media, has_closed_form)) kinds.emplace("MEDIA_CLOSED");
    if (media.empty()) kinds.emplace("NO_MEDIA");
    if (media.size() == 1) kinds.emplace("ONE_MEDIUM");
    if (std::ranges::all_of(media, is_even)) kinds.emplace("EVEN_MEDIA");
    std::string text;
    for (const std::string& kind : kinds) text += "#define " + kind + "\n";
    return text;
}

}  // namespace tyndall::participating_media
