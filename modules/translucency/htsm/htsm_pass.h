#pragma once
/// The technique htsm: heterogeneous translucent shadow maps (Shopf 2006), as published and as single scattering.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "htsm/solid.h"
#include "render/frame_graph.h"
#include "render/kept.h"
#include "render/light_programs.h"
#include "render/specular_table.h"
#include "translucency_settings.h"
#include "translucent_surfaces.h"

namespace tyndall::translucency {

/// The next of 1, 5, 9 and 13.
[[nodiscard]] constexpr int whole_pattern(int rays) {
    return rays <= 1 ? 1 : rays <= 5 ? 5 : rays <= 9 ? 9 : 13;
}

class HtsmPass final : public Pass {
 public:
    /// What programs are compiled for.
    struct Variant {
        HtsmForm form;
        int steps;
        bool bends;   ///< the boundary refracts
        bool voxels;  ///< light is looked up in voxels
        auto operator<=>(const Variant&) const = default;
    };

    HtsmPass(std::shared_ptr<TechniquePlan> plan, const TranslucencySettings& settings);

    [[nodiscard]] std::string_view name() const override { return "translucency.htsm"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    /// What arrives at an object's voxels from one light.
    struct Arriving {
        gpu::Texture light, travels;
        std::string made_from;  ///< all that it depends on, byte by byte
    };
    struct Object {
        Solid solid;
        PaintBinding paint;
        std::vector<Arriving> lights;
        bool unshadowed = false;  ///< by some light, and that has been said
    };

    [[nodiscard]] Variant variant_of(const Surface& surface) const;
    void render(PassContext& context, const Surface& surface, float number, Object& object);
    void arrive(PassContext& context, const Surface& surface, Object& object);
    [[nodiscard]] std::string source_of(Frame& frame, size_t light, const Surface& surface, const Solid& solid) const;
    void bind_entries(const gpu::Program& program, PassContext& context) const;
    void bind(const gpu::Program& program, PassContext& context, const Surface& surface, float number,
              const Object& object);
    void begin(PassContext& context, const Surface& surface, float number, const Object& object);
    /// `begun`: the pixels hold what they had no more.
    void add_lights(PassContext& context, const Surface& surface, float number, Object& object, bool begun);
    static void say_unshadowed(Frame& frame, const Surface& surface, Object& object);

    std::shared_ptr<TechniquePlan> plan_;
    const TranslucencySettings& settings_;
    KeptOfSurfaces<Object> objects_;
    std::map<Variant, LightPrograms> programs_, arrive_programs_;
    SpecularTableTexture table_;
};

}  // namespace tyndall::translucency
