#include "profile_choice.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "core/error.h"

namespace tyndall::skin {
namespace {

physics::DiffusionProfile profile_of(const SixGaussiansProfile&) {
    return physics::six_gaussian_skin();
}

physics::DiffusionProfile profile_of(const GaussiansProfile& from) {
    physics::DiffusionProfile profile;
    glm::vec3 total(0.0f);
    for (const GaussianLobe& lobe : from.lobes) {
        profile.lobes.push_back({lobe.variance_mm2 * 1e-6f, lobe.weight});
        total += lobe.weight;
    }
    if (!glm::all(glm::greaterThan(total, glm::vec3(0.0f))))
        throw Error("gaussians: a channel has no weight: every channel needs a lobe with a weight above 0");
    profile.normalise();
    return profile;
}

}  // namespace

void describe(StructBuilder<SixGaussiansProfile>& d) {
    d.doc("Skin of three layers, by the six Gaussians of d'Eon & Luebke (GPU Gems 3, 2007).");
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
    d.doc("A sum of Gaussians.");
    d.field("lobes", &GaussiansProfile::lobes, "The Gaussians.");
}

std::vector<std::string> profile_names() {
    return {"six_gaussians", "gaussians"};
}

physics::DiffusionProfile make_profile(const ProfileChoice& choice) {
    return std::visit([](const auto& from) { return profile_of(from); }, choice);
}

}  // namespace tyndall::skin
