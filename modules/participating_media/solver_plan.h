#pragma once
/// Who renders what. Single scattering is a sum over pairs of a source and a medium: each pair is a term, rendered by
/// one solver, and the solvers' results add up.

#include <array>
#include <set>
#include <string>
#include <vector>

#include "scene/render_scene.h"

namespace tyndall::participating_media {

/// The solvers by their names in scene files: solver_names().
enum class Solver { ray_marched, froxels, analytic, light_volumes, epipolar, god_rays };
inline constexpr size_t kSolverCount = 6;
/// In the order of Solver.
[[nodiscard]] std::vector<std::string> solver_names();

/// One part of the sum.
struct Term {
    enum class Source { light, emission, environment } source = Source::light;
    size_t light = 0;   ///< of RenderScene::lights; only of Source::light
    size_t medium = 0;  ///< of MediaBuffer::media()
};

/// The terms of a frame, by solver.
class SolverPlan {
 public:
    /// `media` are those that are rendered. Terms that the solver named by a medium cannot express go to the ray march,
    /// which can express all; the log says once which and why.
    void update(const RenderScene& scene, const std::vector<Medium>& media);
    [[nodiscard]] const std::vector<Term>& terms(Solver solver) const { return terms_[static_cast<size_t>(solver)]; }
    [[nodiscard]] bool uses(Solver solver) const { return !terms(solver).empty(); }

 private:
    [[nodiscard]] Solver choose(const RenderScene& scene, const Medium& medium, const Term& term);
    void say_once(std::string text);

    std::array<std::vector<Term>, kSolverCount> terms_;
    std::set<std::string, std::less<>> said_;
};

}  // namespace tyndall::participating_media
