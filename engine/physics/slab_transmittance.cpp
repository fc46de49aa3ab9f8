#include "physics/slab_transmittance.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "physics/layered_diffusion.h"

namespace tyndall::physics {

std::vector<SolidLayer> slab_of(std::span<const SolidLayer> layers, double thickness_m) {
    const std::span<const SolidLayer> covers = layers.first(layers.size() - 1);
    double covered = 0.0;
    for (const SolidLayer& cover : covers) covered += 2.0 * cover.thickness_m;
    const double share = covered > thickness_m ? thickness_m / covered : 1.0;
    std::vector<SolidLayer> slab(covers.begin(), covers.end());
    slab.push_back(layers.back());
    slab.insert(slab.end(), covers.rbegin(), covers.rend());
    for (SolidLayer& layer : slab) layer.thickness_m *= share;
    slab[covers.size()].thickness_m = std::max(thickness_m - covered, 0.0);
    return slab;
}

SlabTransmittance::SlabTransmittance(std::span<const SolidLayer> layers) {
    const auto transmitted = [&](double thickness) {
        return glm::vec3(layered_response(slab_of(layers, thickness), 0.0).transmitted);
    };
    reach_m_ = 1e-6f;
    for (glm::vec3 value(1.0f); reach_m_ < 1.0f && std::max({value.x, value.y, value.z}) > 1e-4f;)
        value = transmitted(double(reach_m_ *= 1.3f));
    for (size_t i = 0; i < kEntries; ++i) {
        const float u = float(i) / float(kEntries - 1);
        values_[i] = transmitted(double(reach_m_ * u * u));
    }
}

glm::vec3 SlabTransmittance::at(float thickness_m) const {
    if (!(thickness_m < reach_m_)) return glm::vec3(0.0f);
    const float x = std::sqrt(std::max(thickness_m, 0.0f) / reach_m_) * float(kEntries - 1);
    const size_t i = std::min(size_t(x), kEntries - 2);
    return glm::mix(values_[i], values_[i + 1], x - float(i));
}

SlabTransmittance SlabTransmittance::scaled(float lengths, const glm::vec3& shares) const {
    SlabTransmittance result = *this;
    result.reach_m_ *= lengths;
    for (glm::vec3& value : result.values_) value *= shares;
    return result;
}

}  // namespace tyndall::physics
