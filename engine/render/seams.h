#pragma once
/// Where modules meet the frame: GLSL functions that programs call without knowing who provides them.
///
/// A provider names a GLSL file and a function in it. The seam makes the text "seams/NAME.glsl", which includes all
/// providers and combines them; programs include that text, are rebuilt when providers change, and ask for the
/// providers' data to be bound.
///
/// Each text "seams/NAME.glsl" declares one function that programs call:
///  - shading_model: LightTerms shade(uint model, ShadingPoint s, LightSample l), and before it, to know where the
///  shadows
///    of that light are looked up, LightReceiver light_receiver(uint model, ShadingPoint s, vec3 to_light)
///  - light_transmittance: vec3 light_transmittance(uint light, vec3 p, vec3 n): a product, 1 without providers
///  - indirect_light: IndirectLight indirect_light(vec3 p, vec3 n, vec3 v, float roughness): a sum
///  - media_segment: MediaSegment media_segment(vec2 uv, vec3 p): front to back. A program that only asks for the
///  surface
///    that is seen at uv may define MEDIA_SEGMENT_OF_SURFACE: providers can leave out the rest.
///  - sky: vec3 sky_radiance(vec3 direction): the last registered, black without
///
/// Provider functions have the same parameters and are called NAME_FUNCTION as given in `function`.

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/shader_library.h"
#include "render/frame_graph.h"
#include "render/pixel_rectangle.h"

namespace tyndall {

enum class Seam { shading_model, light_transmittance, indirect_light, media_segment, sky };
[[nodiscard]] std::string_view name_of(Seam seam);

/// What a frame asks of shading models.
struct ShadingModelUse {
    std::vector<std::string> defines;  ///< of programs that draw there, for the models' GLSL
    PixelRectangle pixels;             ///< where surfaces of a model may be seen; empty: the model is left out
};

struct SeamProvider {
    std::string
        name;  ///< unique within its seam: "shadow_maps", "participating_media"; for shading models the model's name
    std::string include;             ///< GLSL file: "participating_media/transmittance.glsl"
    std::string function;            ///< the function in it that the seam calls
    std::vector<std::string> reads;  ///< frame targets it needs: passes that use the seam then depend on them
    /// Sets uniforms, textures and blocks of a program that includes the provider. May be empty. Called after
    /// program.use().
    std::function<void(const gpu::Program& program, PassContext& context)> bind;
    /// Of a shading model: LightReceiver function(ShadingPoint s, vec3 to_light). Empty: shadows are looked up at the
    /// point, along its normal.
    std::string receiver = {};
    /// Of a shading model: what a frame asks of it. Empty: it may be seen anywhere. A processor that renders pays for
    /// every model of a program at each pixel.
    std::function<ShadingModelUse(PassContext& context)> use = {};
};

/// For programs that see no surface of another shading model than "standard".
inline constexpr const char* kStandardModelOnly = "CHOSEN_SHADING_MODELS";

/// All providers of a renderer.
class Seams {
 public:
    explicit Seams(gpu::ShaderLibrary& shaders);
    ~Seams();
    /// Throws Error when the seam has a provider of that name.
    void add(Seam seam, SeamProvider provider);
    void remove(Seam seam, const std::string& name);
    [[nodiscard]] std::vector<std::string> providers(Seam seam) const;
    /// Number of a shading model for the G-buffer; unknown names give 0 ("standard").
    [[nodiscard]] uint32_t shading_model(const std::string& name) const;

    /// In Pass::execute: all models that the frame asks for besides "standard", and where. Programs that include the
    /// seam and define what this says have these models alone, those that define kStandardModelOnly none of them, and
    /// all others every model.
    [[nodiscard]] ShadingModelUse shading_models(PassContext& context) const;

    /// In Pass::declare: reads of all the seam's providers.
    void declare(Seam seam, PassDeclaration& declaration) const;
    /// In Pass::execute, after program.use().
    void bind(Seam seam, const gpu::Program& program, PassContext& context) const;
    /// Grows with every change: the renderer rebuilds its graph.
    [[nodiscard]] uint64_t version() const;

 private:
    struct Implementation;
    std::unique_ptr<Implementation> self_;
};

}  // namespace tyndall
