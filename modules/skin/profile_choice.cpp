#include "profile_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <glm/vector_relational.hpp>
#include <limits>
#include <mutex>

#include "core/error.h"
#include "physics/skin_profiles.h"

namespace tyndall::skin {
namespace {

constexpr float kMm = 1e-3f;
constexpr double kPerMm = 1e3;
constexpr float kMostIor = 2.0f;  // so far the fits of Fresnel's moments hold

bool all_above(const glm::vec3& value, float limit) {
    return glm::all(glm::greaterThan(value, glm::vec3(limit))) &&
           glm::all(glm::lessThan(value, glm::vec3(std::numeric_limits<float>::infinity())));
}
bool all_from_0(const glm::vec3& value) {
    return all_above(value, -std::numeric_limits<float>::min());
}

MadeProfile of_solid(const physics::SolidProfile& solid) {
    MadeProfile made{solid.fit.profile, solid.albedo, solid.fit.error, solid.fit.edge_error, std::nullopt};
    if (!solid.layers.empty()) made.transmittance.emplace(solid.layers);
    const float eta = solid.layers.empty() ? kSkinIor : float(solid.layers.front().eta);
    made.corrections =
        physics::profile_corrections(made.albedo, glm::sqrt(made.profile.mean_square()), std::max(eta, 1.01f));
    return made;
}

MadeProfile make(const SixGaussiansProfile&) {
    return {.profile = physics::six_gaussian_skin(), .transmittance = std::nullopt};
}

MadeProfile make(const Skin1Profile&) {
    return of_solid(physics::solid_profile({physics::jensen_skin1()}));
}

MadeProfile make(const Skin2Profile&) {
    return of_solid(physics::solid_profile({physics::jensen_skin2()}));
}

MadeProfile make(const ThreeLayersProfile&) {
    return of_solid(physics::solid_profile(physics::three_layer_skin()));
}

MadeProfile make(const BurleyProfile& from) {
    if (!all_above(from.albedo, 0.0f) || !glm::all(glm::lessThanEqual(from.albedo, glm::vec3(1.0f))))
        throw Error("profile burley: each channel's albedo must be above 0 and at most 1");
    if (!all_above(from.mean_free_path_mm, 0.0f))
        throw Error("profile burley: each channel's mean_free_path_mm must be above 0");
    return of_solid(physics::burley_profile(from.albedo, kMm * from.mean_free_path_mm));
}

physics::SolidLayer solid_layer(const ProfileLayer& from, size_t index, bool last) {
    const auto wrong = [&](std::string_view what) {
        return Error(fmt::format("profile layers: layer {}: {}", index, what));
    };
    if (!all_above(from.scattering_per_mm, 0.0f))
        throw wrong("each channel's scattering_per_mm must be above 0: light that is not scattered does not spread");
    if (!all_from_0(from.absorption_per_mm)) throw wrong("absorption_per_mm must not be negative");
    if (!(from.ior >= 1.0f && from.ior <= kMostIor))
        throw wrong(fmt::format("an ior of {} (expected 1 to {})", from.ior, kMostIor));
    if (!(from.thickness_mm >= 0.0f)) throw wrong("thickness_mm must not be negative");
    if (from.thickness_mm == 0.0f && !last)
        throw wrong("thickness_mm is 0 (only the last layer may go on without end)");
    physics::SolidLayer layer;
    if (from.thickness_mm > 0.0f) layer.thickness_m = double(from.thickness_mm) / kPerMm;
    layer.sigma_a = kPerMm * glm::dvec3(from.absorption_per_mm);
    layer.sigma_s_reduced = kPerMm * glm::dvec3(from.scattering_per_mm);
    layer.eta = double(from.ior);
    return layer;
}

MadeProfile make(const LayersProfile& from) {
    if (from.layers.empty()) throw Error("profile layers: no layer (expected layers, from the top down)");
    std::vector<physics::SolidLayer> layers;
    for (const ProfileLayer& layer : from.layers)
        layers.push_back(solid_layer(layer, layers.size(), layers.size() + 1 == from.layers.size()));
    return of_solid(physics::solid_profile(layers));
}

MadeProfile make(const GaussiansProfile& from) {
    MadeProfile made;
    glm::vec3 total(0.0f);
    for (const GaussianLobe& lobe : from.lobes) {
        if (!(lobe.variance_mm2 > 0.0f) || std::isinf(lobe.variance_mm2))
            throw Error(fmt::format("profile gaussians: lobe {}: a variance_mm2 of {} (expected above 0)",
                                    made.profile.lobes.size(), lobe.variance_mm2));
        if (!all_from_0(lobe.weight))
            throw Error(
                fmt::format("profile gaussians: lobe {}: a weight must not be negative", made.profile.lobes.size()));
        made.profile.lobes.push_back({lobe.variance_mm2 * kMm * kMm, lobe.weight});
        total += lobe.weight;
    }
    if (from.lobes.empty()) throw Error("profile gaussians: no lobe (expected lobes of variance_mm2 and weight)");
    if (!all_above(total, 0.0f))
        throw Error("profile gaussians: a channel's weights sum to 0 (expected a lobe with a weight above 0 for each)");
    made.profile.normalise();
    return made;
}

/// The profiles made last, newest first.
class KeptProfiles {
 public:
    std::shared_ptr<const MadeProfile> get(const ProfileChoice& choice) {
        const std::scoped_lock lock(mutex_);
        const auto found = std::ranges::find(kept_, choice, &Entry::choice);
        if (found != kept_.end()) return found->made;
        auto made =
            std::make_shared<const MadeProfile>(std::visit([](const auto& from) { return make(from); }, choice));
        kept_.push_front({choice, made});
        if (kept_.size() > kMost) kept_.pop_back();
        return made;
    }

 private:
    static constexpr size_t kMost = 64;
    struct Entry {
        ProfileChoice choice;
        std::shared_ptr<const MadeProfile> made;
    };
    std::mutex mutex_;
    std::deque<Entry> kept_;
};

}  // namespace

void describe(StructBuilder<SixGaussiansProfile>& d) {
    d.doc("Skin of three layers, by the six Gaussians of d'Eon & Luebke (GPU Gems 3, 2007).");
}

void describe(StructBuilder<Skin1Profile>& d) {
    d.doc("Skin 1 of Jensen et al. 2001 by photon beam diffusion and single scattering.");
}

void describe(StructBuilder<Skin2Profile>& d) {
    d.doc("Skin 2 of Jensen et al. 2001 by photon beam diffusion and single scattering.");
}

void describe(StructBuilder<ThreeLayersProfile>& d) {
    d.doc("Epidermis, upper and bloody dermis with the coefficients of Donner & Jensen 2005.");
}

void describe(StructBuilder<BurleyProfile>& d) {
    d.doc("Normalised diffusion (Christensen & Burley 2015).");
    d.field("albedo", &BurleyProfile::albedo, "Of the light that has entered, what leaves; per channel.")
        .range(1e-3, 1.0);
    d.field("mean_free_path_mm", &BurleyProfile::mean_free_path_mm,
            "How far light goes before it is scattered or absorbed (reduced), per channel.")
        .unit("mm")
        .range(1e-4, 1e4);
}

void describe(StructBuilder<ProfileLayer>& d) {
    using L = ProfileLayer;
    d.doc("One layer of a solid.");
    d.field("thickness_mm", &L::thickness_mm, "Thickness; 0, for the last layer only, is without end.")
        .unit("mm")
        .range(0.0, 1e4);
    d.field("absorption_per_mm", &L::absorption_per_mm, "Absorption coefficient per channel.")
        .unit("1/mm")
        .range(0.0, 1e4);
    d.field("scattering_per_mm", &L::scattering_per_mm, "Reduced scattering coefficient per channel.")
        .unit("1/mm")
        .range(1e-4, 1e4);
    d.field("ior", &L::ior, "Index of refraction; those of the first and the last layer count.")
        .range(1.0, double(kMostIor));
}

void describe(StructBuilder<LayersProfile>& d) {
    d.doc("Layers of a solid by their coefficients: Donner & Jensen 2005, solved without their thick-layer limit.");
    d.field("layers", &LayersProfile::layers, "From the top down.");
}

void describe(StructBuilder<GaussianLobe>& d) {
    d.doc("One Gaussian.");
    d.field("variance_mm2", &GaussianLobe::variance_mm2, "Variance of the distance along one axis.")
        .unit("mm2")
        .range(1e-6, 1e6);
    d.field("weight", &GaussianLobe::weight, "Per channel; the weights of all lobes are made to sum to 1.")
        .range(0.0, 1e6);
}

void describe(StructBuilder<GaussiansProfile>& d) {
    d.doc("A sum of Gaussians; `tyndall profile` prints those of other choices in this form.");
    d.field("lobes", &GaussiansProfile::lobes, "The Gaussians.");
}

std::vector<std::string> profile_names() {
    return {"six_gaussians", "skin_1", "skin_2", "three_layers", "burley", "layers", "gaussians"};
}

std::shared_ptr<const MadeProfile> made_profile(const ProfileChoice& choice) {
    static KeptProfiles kept;
    return kept.get(choice);
}

physics::DiffusionProfile make_profile(const ProfileChoice& choice) {
    return made_profile(choice)->profile;
}

}  // namespace tyndall::skin
