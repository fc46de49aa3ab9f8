#pragma once
/// The techniques six_gaussians and hable: light that enters skin is gathered in a map laid out by the mesh's UVs, and
/// spreads there.

#include <memory>

#include "render/frame_graph.h"
#include "render/kept.h"
#include "render/light_programs.h"
#include "screen/screen_settings.h"
#include "shading_model.h"
#include "texture_space/surface_maps.h"
#include "texture_space/usable_maps.h"

namespace tyndall::skin {

/// Borshukov & Lewis 2003; d'Eon & Luebke, GPU Gems 3, 2007, 14.5; Hable et al. 2009.
class TextureSpacePass final : public Pass {
 public:
    TextureSpacePass(std::shared_ptr<SkinTables> tables, const SkinSettings& settings);

    [[nodiscard]] std::string_view name() const override { return "skin.texture_space"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    /// A surface in its frame.
    struct Drawn {
        const Surface& surface;
        size_t index;  ///< in the scene
        MapTechnique technique;
        Stretch stretch;
        physics::DiffusionProfile profile;  ///< metres of the map
        float pre_scatter;
        SurfaceMaps& maps;
    };

    void render(PassContext& context, size_t index, MapTechnique technique);
    SurfaceMaps& maps_of(PassContext& context, const Surface& surface, MapTechnique technique, const Stretch& stretch);
    [[nodiscard]] std::string state_of(PassContext& context, const Drawn& drawn) const;
    void make(PassContext& context, const Drawn& drawn, const ChunkSet& seen);
    void light(PassContext& context, const Drawn& drawn, const ChunkSet& set);
    void begin(PassContext& context, const Drawn& drawn, const ChunkSet& set, bool dark);
    void draw(PassContext& context, const Drawn& drawn);

    std::shared_ptr<SkinTables> tables_;
    const SkinSettings& settings_;
    Kept<MapKey, std::unique_ptr<SurfaceMaps>> maps_;
    UsableMaps usable_;
    LightPrograms light_programs_, first_light_programs_;
    ChunkList list_;  ///< for one dispatch
};

}  // namespace tyndall::skin
