#pragma once
/// Who renders what. Single scattering is a sum over pairs of a source and a medium: each pair is a term, rendered by
/// one solver, and the solvers' results add up.

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "media_settings.h"
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
    ///
    /// A medium of the solver "auto": terms that nothing shades and that have a closed form are analytic; the rest is
    /// marched, or left to the froxels when these are more than `settings.auto_marches`. The log says what it chose,
    /// whenever that changes.
    void update(const RenderScene& scene, const std::vector<Medium>& media, const MediaSettings& settings);
    [[nodiscard]] const std::vector<Term>& terms(Solver solver) const { return terms_[static_cast<size_t>(solver)]; }
    [[nodiscard]] bool uses(Solver solver) const { return !terms(solver).empty(); }

 private:
    /// What the medium's solver makes of the term; nothing for auto.
    [[nodiscard]] std::optional<Solver> named(const RenderScene& scene, const Medium& medium, const Term& term);
    /// Shares out what was left to auto.
    void choose(const RenderScene& scene, const std::vector<Medium>& media, const MediaSettings& settings,
                const std::vector<Term>& left);
    void add(Solver solver, const Term& term) { terms_[static_cast<size_t>(solver)].push_back(term); }
    void say_once(std::string text);

    std::array<std::vector<Term>, kSolverCount> terms_;
    std::set<std::string, std::less<>> said_;
    std::string chosen_;  ///< by auto, as the log has it
};

}  // namespace tyndall::participating_media
