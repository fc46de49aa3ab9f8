#pragma once
/// Scenes that tests make in code, and what a trace of them measures.

#include <string>

#include "reference/trace.h"
#include "scene/components.h"

namespace tyndall::reference {

/// The mean of a traced picture and its standard error, per channel.
struct Measured {
    glm::dvec3 mean{0.0}, error{0.0};
};
[[nodiscard]] Measured mean_of(const Film& film);
/// Of one component of the radiance; the error is the whole radiance's.
[[nodiscard]] Measured mean_of(const Film& film, Component component);
[[nodiscard]] Measured measure(const RenderScene& scene, const TraceSettings& settings, int64_t samples);

/// `pixels` x `pixels`, in batches of 256 or less, so that there are at least four.
[[nodiscard]] TraceSettings square_picture(int pixels, int64_t samples);

/// Prints the measured relative error and its limit, and expects that |measured / truth - 1| is below the limit in
/// every channel, and that three standard errors are, too: a test that noise can pass says nothing.
void expect_near(const std::string& what, const Measured& measured, const glm::dvec3& truth, double limit);
/// Prints and expects that a number is below its limit.
void expect_below(const std::string& what, double measured, double limit);

[[nodiscard]] Material white_diffuse();
[[nodiscard]] Surface shape(Primitive primitive, const glm::mat4& transform,
                            const Material& material = white_diffuse());
/// Places a unit shape so that it fills this box.
[[nodiscard]] glm::mat4 between(const glm::vec3& low, const glm::vec3& high);
/// At `eye`, with a vertical field of view in degrees and exposure 1.
[[nodiscard]] Camera camera_at(const glm::vec3& eye, const glm::vec3& target, float fov_deg);
/// A uniform field of radiance 1 around everything, seen by `camera`.
[[nodiscard]] RenderScene uniform_field(const Camera& camera);
[[nodiscard]] PhaseFunction henyey_greenstein(float g);

}  // namespace tyndall::reference
