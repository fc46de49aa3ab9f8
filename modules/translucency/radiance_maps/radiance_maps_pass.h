#pragma once
/// The technique radiance_maps: maps of the light that leaves an object, gathered over some frames from maps of what
/// the lights see of it (Dal Corso 2014).

#include <memory>

#include "body_space.h"
#include "interior_buffers.h"
#include "radiance_maps/light_maps.h"
#include "radiance_maps/view_maps.h"
#include "render/frame_graph.h"
#include "render/kept.h"
#include "render/light_programs.h"
#include "translucency_settings.h"
#include "translucent_surfaces.h"

namespace tyndall::translucency {

class RadianceMapsPass final : public Pass {
 public:
    RadianceMapsPass(std::shared_ptr<TechniquePlan> plan, const TranslucencySettings& settings);

    [[nodiscard]] std::string_view name() const override { return "translucency.radiance_maps"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    struct Body {
        std::unique_ptr<ViewMaps> maps;
        glm::vec3 shape{1.0f};
    };
    struct Object {
        const ViewMaps* body = nullptr;
        InteriorBuffers interior;
        InteriorKey key;  ///< of the interior
        LightMaps lights;
        gpu::Buffer balanced;  ///< of the vertices
        gpu::Texture leaving;  ///< a layer a view: what leaves, and its coarser levels
        gpu::Texture scales;   ///< likewise: what the kernel is multiplied by
        gpu::Buffer state;     ///< shaders/radiance_maps/layers.glsl
        int samples = 0;
        bool restart = true;
        bool said_left_out = false;
    };

    /// A surface to render.
    struct Seen {
        const Surface& surface;
        const ViewMaps& body;
        Object& object;
        glm::mat4 world_from_body;
        float metres_of_unit;
        float number;  ///< of the surface, as the G-buffer has it
    };

    void render(PassContext& context, const Surface& surface, float number);
    Body& body_of(PassContext& context, const Surface& surface);
    Object& object_of(const Surface& surface, const ViewMaps& body);
    void prepare(PassContext& context, const Seen& seen);
    void enter(PassContext& context, const Seen& seen);
    void gather(PassContext& context, const Seen& seen);
    void filter(PassContext& context, const Seen& seen) const;
    static void forget_around(PassContext& context);
    static void light_around(PassContext& context, const Seen& seen);
    void combine(PassContext& context, const Seen& seen);

    std::shared_ptr<TechniquePlan> plan_;
    const TranslucencySettings& settings_;
    Kept<ShapeKey, Body> bodies_;
    KeptOfSurfaces<Object> objects_;
    LightPrograms enter_programs_;
    gpu::Texture blue_noise_;
};

}  // namespace tyndall::translucency
