#pragma once
/// What the quick techniques, wrap and thickness, know of a body until it changes.

#include <vector>

#include "body_size.h"
#include "interior_buffers.h"
#include "translucency_settings.h"
#include "wrap/wrap_amount.h"

namespace tyndall::translucency {

struct QuickBody {
    /// Columns of the patterns, from grazing to along the normal: so many that the nearest will do.
    static constexpr int kCosines = 1024;

    InteriorBuffers interior;
    BodyRadius size;
    WrapAmount wrap;
    /// By the cosine to the eye, what the compose pass is given for a unit of light, so that the base looks as what
    /// leaves does: first of light that entered near by, then of light from deep inside (near_pattern and deep_pattern
    /// of shaders/interior.glsl).
    std::vector<glm::vec4> patterns;
    gpu::Texture passing;     ///< table_of_passing of thickness/thickness_shares.h
    float farthest_m = 0.0f;  ///< the last distance in it
    uint64_t version = 0;     ///< QuickPass's number of these patterns; 0 before they are made

    /// Once a frame; true when something was made anew. `paints` knows the paint.
    bool update(const Surface& surface, const TranslucencySettings& settings, PaintStore& paints);
};

}  // namespace tyndall::translucency
