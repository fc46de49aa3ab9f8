#include "scene/extraction.h"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "core/error.h"
#include "ecs/transform.h"
#include "scene/components.h"
#include "scene/environment.h"

namespace tyndall {
namespace {

/// How long a RenderScene's lists are, to take back what a failed extractor added.
struct Lengths {
    size_t surfaces, lights, media, probes, cameras;
    Sky sky;

    explicit Lengths(const RenderScene& scene)
        : surfaces(scene.surfaces.size()),
          lights(scene.lights.size()),
          media(scene.media.size()),
          probes(scene.probes.size()),
          cameras(scene.cameras.size()),
          sky(scene.sky) {}
    void restore(RenderScene& scene) const {
        scene.surfaces.resize(surfaces);
        scene.lights.resize(lights);
        scene.media.resize(media);
        scene.probes.resize(probes);
        scene.cameras.resize(cameras);
        scene.sky = sky;
    }
};

float box_volume(const LightProbe& probe) {
    return probe.extent_m->x * probe.extent_m->y * probe.extent_m->z;
}

void sort_probes(std::vector<LightProbe>& probes) {
    std::stable_sort(probes.begin(), probes.end(), [](const LightProbe& a, const LightProbe& b) {
        if (a.extent_m.has_value() != b.extent_m.has_value()) return a.extent_m.has_value();
        return a.extent_m && box_volume(a) < box_volume(b);
    });
}

}  // namespace

struct Extractors::Implementation {
    struct Entry {
        std::string component;
        Extractor extractor;
    };
    /// Where a failure was; index and generation name the entity.
    using Place = std::tuple<std::string, uint32_t, uint32_t>;

    std::vector<Entry> entries;
    std::map<Place, std::string> failures;  ///< the last message of each, so that it is reported once
    std::vector<ExtractionProblem> fresh;
    LightsOfEnvironment lights_of_environment;

    void report(const Place& place, const std::string& message) {
        std::string& last = failures[place];
        if (last == message) return;
        last = message;
        const auto& [component, index, generation] = place;
        fresh.push_back({{index, generation}, component, message});
    }
    void recovered(const Place& place) { failures.erase(place); }

    /// Runs one extractor on one component.
    void run(const Entry& entry, const ExtractContext& context, const void* component, RenderScene& scene) {
        const Lengths before(scene);
        const auto place = [&] { return Place{entry.component, context.entity.index, context.entity.generation}; };
        try {
            entry.extractor(context, component, scene);
            if (!failures.empty()) recovered(place());
        } catch (const std::exception& error) {
            before.restore(scene);
            const std::string& name = context.world.name(context.entity);
            report(place(), (name.empty() ? "an entity" : "entity '" + name + "'") + ", " + entry.component + ": " +
                                error.what());
        }
    }

    void run_all(World& world, AssetStore& assets, RenderScene& scene) {
        struct Walk {
            Implementation& self;
            const Entry* entry;
            World& world;
            AssetStore& assets;
            RenderScene& scene;
            ComponentId matrix_id;
        } walk{*this, nullptr, world, assets, scene, world.registry().find<WorldMatrix>()};
        for (const Entry& entry : entries) {
            const ComponentId id = world.registry().find(entry.component);
            if (id == ComponentId::none) continue;
            walk.entry = &entry;
            const auto visit = [](void* at, Entity entity, void* component) {
                auto& w = *static_cast<Walk*>(at);
                const auto* matrix = static_cast<const WorldMatrix*>(w.world.find(entity, w.matrix_id));
                if (!matrix) return;
                const ExtractContext context{w.world, w.assets, entity, matrix->current, matrix->previous};
                w.self.run(*w.entry, context, component, w.scene);
            };
            world.each(id, visit, &walk);
        }
    }

    void choose_camera(const World& world, std::string_view wanted, RenderScene& scene) {
        const Place place{"camera choice", Entity{}.index, Entity{}.generation};
        if (scene.cameras.empty() && wanted.empty()) return;
        std::vector<std::string> names;
        for (const Camera& camera : scene.cameras) names.push_back(world.name(camera.entity));
        const auto found = std::find(names.begin(), names.end(), wanted);
        const bool known = wanted.empty() || found != names.end();
        if (known)
            recovered(place);
        else
            report(place, Diagnostic{{},
                                     "no camera is named '" + std::string(wanted) + "'",
                                     "the name of an entity with a camera",
                                     nearest_name(wanted, names)}
                              .text());
        const auto index = wanted.empty() || !known ? 0 : static_cast<size_t>(found - names.begin());
        if (!scene.cameras.empty()) scene.camera = scene.cameras[index];
    }
};

Extractors::Extractors() : self_(std::make_unique<Implementation>()) {}
Extractors::~Extractors() = default;

void Extractors::add(std::string component, Extractor extractor) {
    self_->entries.push_back({std::move(component), std::move(extractor)});
}

void Extractors::remove(std::string_view component) {
    std::erase_if(self_->entries, [&](const Implementation::Entry& entry) { return entry.component == component; });
    std::erase_if(self_->failures, [&](const auto& failure) { return std::get<0>(failure.first) == component; });
}

std::vector<ExtractionProblem> Extractors::extract(World& world, AssetStore& assets, std::string_view camera,
                                                   RenderScene& scene) {
    update_world_matrices(world);
    scene.clear();
    self_->fresh.clear();
    self_->run_all(world, assets, scene);
    sort_probes(scene.probes);
    self_->lights_of_environment.add_to(scene);
    self_->choose_camera(world, camera, scene);
    return std::move(self_->fresh);
}

}  // namespace tyndall
