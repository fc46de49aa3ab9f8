// The module: what it registers.

#include "module/module.h"
#include "pixels/surface_pixels_pass.h"
#include "screen/screen_pass.h"
#include "skin_component.h"
#include "texture_space/texture_space_pass.h"
#include "transmission/transmission_pass.h"

namespace tyndall::skin {

class Skin final : public Module {
 public:
    void install(Registrar& registrar) override {
        registrar.component<SkinComponent>(make_skin_extractor());
        const SkinSettings& settings = registrar.settings<SkinSettings>();
        const auto tables = std::make_shared<SkinTables>();
        registrar.seam(Seam::shading_model, shading_model(tables));
        registrar.pass(std::make_unique<SurfacePixelsPass>(settings));
        registrar.pass(std::make_unique<TransmissionPass>(tables, settings, SpreadIn::light_or_screen));
        registrar.pass(std::make_unique<ScreenPass>(tables, settings));
        registrar.pass(std::make_unique<TextureSpacePass>(tables, settings));
        registrar.pass(std::make_unique<TransmissionPass>(tables, settings, SpreadIn::map));
    }
};

}  // namespace tyndall::skin

TYNDALL_MODULE(tyndall::skin::Skin, "0.1",
               "Skin: light that spreads under a surface, in millimetres, and an oily layer.", "")
