#include "tsm/level_kernels.h"

#include <cmath>
#include <glm/vector_relational.hpp>
#include <numbers>

#include "interior_block.h"

namespace tyndall::translucency {
namespace {

/// Width of the first level's narrowest Gaussian in texels: a grid of such Gaussians is even within 0.2 %.
constexpr float kFirstWidth = 0.85f;

}  // namespace

LevelKernels make_level_kernels(const KernelKey& key) {
    LevelKernels made;
    made.first_width = kFirstWidth * key.texel_m;
    for (int level = 0; level < key.levels; ++level) {
        const float texel = std::ldexp(key.texel_m, level);
        const float radius = level == 0 ? made.first_width : texel / std::sqrt(std::numbers::pi_v<float>);
        const RadialKernel kernel(key.optics, key.model, key.scaling, radius);
        for (int i = 0; i < LevelKernels::kColumns; ++i) {
            const float x = float(i) / float(LevelKernels::kColumns - 1), r = key.farthest_m * x * x;
            const glm::vec3 value = key.scale * (level == 0 ? kernel.at(r) : kernel.exact(r));
            made.table.emplace_back(value, 1.0f - std::exp(-r / deep_distance(key.optics)));
        }
        if (level == 0) made.first_height = key.scale * kernel.at(0.0f);
    }
    made.own_share = made.first_height * (std::numbers::pi_v<float> * made.first_width * made.first_width);
    return made;
}

float reach_of(const RadialKernel& kernel) {
    constexpr float kShare = 0.998f, kLeast = 1e-6f, kMost = 1e4f;
    float reach = kLeast;
    while (reach < kMost && glm::any(glm::lessThan(kernel.share_within(reach), glm::vec3(kShare)))) reach *= 1.1f;
    return reach;
}

}  // namespace tyndall::translucency
