#pragma once
/// The technique scatter_maps: light inside is followed to where a light's map says that it entered (Ki 2009).

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "interior_buffers.h"
#include "phase_table.h"
#include "render/frame_graph.h"
#include "render/kept.h"
#include "render/light_programs.h"
#include "render/pixel_rectangle.h"
#include "render/specular_table.h"
#include "scatter_maps/scatter_block.h"
#include "scatter_maps/scatter_map.h"
#include "translucency_settings.h"
#include "translucent_surfaces.h"

namespace tyndall::translucency {

class ScatterMapsPass final : public Pass {
 public:
    /// What programs are compiled for.
    struct Variant {
        ScatterMapsForm form;
        ScatterMapsLight light;
        ScatterMapsFalloff falloff;
        int steps;
        bool bends;  ///< the boundary refracts
        auto operator<=>(const Variant&) const = default;
    };

    ScatterMapsPass(std::shared_ptr<TechniquePlan> plan, const TranslucencySettings& settings);

    [[nodiscard]] std::string_view name() const override { return "translucency.scatter_maps"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    struct Object {
        uint64_t mesh = 0;
        glm::vec3 shape{0.0f};     ///< how the mesh's axes are stretched
        float body_radius = 0.0f;  ///< metres; 0 = it encloses nothing
        ScatterKey key;
        uint64_t version = 0;  ///< grows with the key
        gpu::Buffer block;
        gpu::Texture kernel, cosines;
        InteriorBuffers interior;
        PhaseTexture phase;
        std::vector<ScatterMap> maps;  ///< a light each
    };

    [[nodiscard]] Variant variant_of(const Surface& surface) const;
    /// False when there is no inside.
    bool update_body(Object& object, const Surface& surface) const;
    void update_tables(Object& object, const Surface& surface) const;
    void update_maps(PassContext& context, const Surface& surface, Object& object);
    void render(PassContext& context, const Surface& surface, float number, const PixelRectangle& pixels,
                const Object& object);
    void begin(PassContext& context, const Surface& surface, float number, const Object& object);
    void add_lights(PassContext& context, const Surface& surface, float number, const Object& object);
    /// Light that scatters more than once, of form ki.
    void blur(PassContext& context, const PixelRectangle& pixels, float number, const Object& object);
    void spread(PassContext& context, const Surface& surface, float number, const Object& object);
    static void bind_solid(const gpu::Program& program, const Object& object);

    std::shared_ptr<TechniquePlan> plan_;
    const TranslucencySettings& settings_;
    KeptOfSurfaces<Object> objects_;
    std::map<Variant, LightPrograms> programs_;
    LightPrograms entry_programs_;
    SpecularTableTexture table_;
};

}  // namespace tyndall::translucency
