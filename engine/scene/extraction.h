#pragma once
/// From the World to the RenderScene: a function per component type, registered beside it.

#include <functional>
#include <memory>
#include <string>

#include "scene/asset_store.h"
#include "scene/render_scene.h"

namespace tyndall {

/// What an extractor may look at.
struct ExtractContext {
    const World& world;
    AssetStore& assets;
    Entity entity;
    const glm::mat4& transform;           ///< to the world
    const glm::mat4& previous_transform;  ///< the last frame's
};

/// Adds what one component means to the scene. May throw Error (a missing asset): the entity is then left out, the
/// error logged once per component and version.
using Extractor = std::function<void(const ExtractContext&, const void* component, RenderScene&)>;

/// Why something of the world is not in the RenderScene.
struct ExtractionProblem {
    Entity entity;          ///< null for the choice of the camera
    std::string component;  ///< that could not be extracted
    std::string text;       ///< for people; names the entity
};

/// All extractors of a program.
class Extractors {
 public:
    Extractors();
    ~Extractors();
    void add(std::string component, Extractor extractor);
    void remove(std::string_view component);

    /// Rebuilds `scene` from the world: updates world matrices, runs the extractors, sorts probes, turns the
    /// environment into lights where that is asked for, picks the camera
    /// (`camera` names its entity; empty = first). Returns this frame's failed extractions that were not reported
    /// before.
    std::vector<ExtractionProblem> extract(World& world, AssetStore& assets, std::string_view camera,
                                           RenderScene& scene);

 private:
    struct Implementation;
    std::unique_ptr<Implementation> self_;
};

/// Registers the engine's own components (scene/components.h) and their extractors.
void register_engine_components(ComponentRegistry& registry, Extractors& extractors);

}  // namespace tyndall
