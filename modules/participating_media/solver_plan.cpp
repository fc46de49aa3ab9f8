#include "solver_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "analytic/analytic_pass.h"
#include "core/log.h"
#include "environment.h"
#include "epipolar/epipolar_pass.h"
#include "froxels/froxel_pass.h"
#include "god_rays/god_rays_pass.h"
#include "light_volumes/light_volumes_pass.h"

namespace tyndall::participating_media {
namespace {

struct SolverTraits {
    std::string_view name;
    /// Why it cannot express a term; empty when it can.
    std::string (*cannot)(const RenderScene&, const Medium&, const Term&);
};

std::string can_all(const RenderScene&, const Medium&, const Term&) {
    return {};
}

/// In the order of Solver.
constexpr std::array<SolverTraits, kSolverCount> kTraits{{
    {"ray_marched", can_all},
    {"froxels", froxels_cannot},
    {"analytic", analytic_cannot},
    {"light_volumes", light_volumes_cannot},
    {"epipolar", epipolar_cannot},
    {"god_rays", god_rays_cannot},
}};

std::string_view name_of(Solver solver) {
    return kTraits.at(static_cast<size_t>(solver)).name;
}

}  // namespace

std::vector<std::string> solver_names() {
    std::vector<std::string> names;
    for (const SolverTraits& solver : kTraits) names.emplace_back(solver.name);
    return names;
}

void SolverPlan::say_once(std::string text) {
    if (said_.insert(text).second) log::info("participating_media: {}", text);
}

std::optional<Solver> SolverPlan::named(const RenderScene& scene, const Medium& medium, const Term& term) {
    const auto named = std::ranges::find(kTraits, medium.solver, &SolverTraits::name);
    if (named == kTraits.end()) return {};  // auto
    const std::string reason = named->cannot(scene, medium, term);
    if (reason.empty()) return static_cast<Solver>(named - kTraits.begin());
    say_once(fmt::format("{} {}: ray_marched renders it instead", medium.solver, reason));
    return Solver::ray_marched;
}

void SolverPlan::choose(const RenderScene& scene, const std::vector<Medium>& media, const MediaSettings& settings,
                        const std::vector<Term>& left) {
    const auto smooth = [&](const Term& term) { return analytic_cannot(scene, media[term.medium], term).empty(); };
    const auto smooth_terms = std::ranges::count_if(left, smooth), shaded = std::ssize(left) - smooth_terms;
    const Solver rest = shaded <= settings.auto_marches ? Solver::ray_marched : Solver::froxels;
    for (const Term& term : left) add(smooth(term) ? Solver::analytic : rest, term);
    std::string chosen;
    if (smooth_terms > 0) chosen += fmt::format(", {} by analytic", smooth_terms);
    if (shaded > 0)
        chosen += fmt::format(", {} by {} (up to {} are marched)", shaded, name_of(rest), settings.auto_marches);
    if (chosen != chosen_ && !chosen.empty())
        log::info("participating_media: auto: of {} pairs of a source and a medium{}", left.size(), chosen);
    chosen_ = std::move(chosen);
}

void SolverPlan::update(const RenderScene& scene, const std::vector<Medium>& media, const MediaSettings& settings) {
    for (auto& terms : terms_) terms.clear();
    std::vector<Term> left;
    const auto place = [&](const Term& term) {
        if (const auto solver = named(scene, media[term.medium], term))
            add(*solver, term);
        else
            left.push_back(term);
    };
    const bool environment = !media.empty() && has_environment(scene);
    for (size_t medium = 0; medium < media.size(); ++medium) {
        if (media[medium].sigma_s_per_m != glm::vec3(0.0f))
            for (size_t light = 0; light < scene.lights.size(); ++light) place({Term::Source::light, light, medium});
        if (environment && media[medium].sigma_s_per_m != glm::vec3(0.0f))
            place({Term::Source::environment, 0, medium});
        if (media[medium].emission_cd_m2_per_m != glm::vec3(0.0f) || media[medium].temperature)
            place({Term::Source::emission, 0, medium});
    }
    choose(scene, media, settings, left);
}

}  // namespace tyndall::participating_media
