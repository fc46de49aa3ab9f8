#pragma once
/// What a path is while it is traced: for the parts of PathTracer alone.

#include "reference/channels.h"
#include "reference/path.h"

namespace tyndall::reference {

inline constexpr int kMostTurns = 100000;  ///< far beyond any path that roulette lets live

/// Power heuristic: the weight of a strategy of density `a` beside one of density `b`.
[[nodiscard]] inline float power_weight(float a, float b) {
    if (!(a > 0.0f)) return 0.0f;
    const float r = b / a;
    return 1.0f / (1.0f + r * r);
}

struct PathTracer::Path {
    Ray ray;
    glm::vec3 f{1.0f};      ///< contribution over the hero channel's density
    glm::vec3 ratio{1.0f};  ///< each channel's density over the hero's
    int hero = 0;
    Nesting nesting;
    int order = 0;  ///< times scattered
    int first = 0;  ///< what scattered first: 1 a surface, 2 a medium
    int turns = 0;
    bool camera = true;    ///< has gone straight from the camera
    bool specular = true;  ///< the last turn was a mirror's, or there was none: no other strategy finds what it meets
    float turn_pdf = 0.0f;
    glm::vec3 turn_place{0.0f};
    Sampler& sampler;
    std::vector<MediaRay::Stretch>& stretches;
    PathResult result;
    float bent = 1.0f;  ///< what refraction will scale back when the path leaves again
    bool seen = false;  ///< albedo and normal are known

    [[nodiscard]] glm::vec3 weight() const { return f / mean_of(ratio); }
};

}  // namespace tyndall::reference
