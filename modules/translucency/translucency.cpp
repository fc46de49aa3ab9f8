// The module: what it registers.

#include "htsm/htsm_pass.h"
#include "leaves/leaves_pass.h"
#include "module/module.h"
#include "paint/paint_passes.h"
#include "points/points_pass.h"
#include "quick/quick_pass.h"
#include "radiance_maps/radiance_maps_pass.h"
#include "scatter_maps/scatter_maps_pass.h"
#include "tsm/tsm_pass.h"

namespace tyndall::translucency {

class Translucency final : public Module {
 public:
    void install(Registrar& registrar) override {
        const TranslucencySettings& settings = registrar.settings<TranslucencySettings>();
        const auto plan = std::make_shared<TechniquePlan>();
        const auto table = std::make_shared<QuickTable>();
        registrar.seam(Seam::shading_model, thin_shading_model(settings));
        registrar.seam(Seam::shading_model, interior_shading_model(table));
        registrar.pass(std::make_unique<LeavesPass>(settings));
        registrar.pass(std::make_unique<QuickPass>(plan, table, settings));
        registrar.pass(std::make_unique<PaintMarkPass>(plan, settings));
        registrar.pass(std::make_unique<PointsPass>(plan, settings));
        registrar.pass(std::make_unique<HtsmPass>(plan, settings));
        registrar.pass(std::make_unique<TsmPass>(plan, settings));
        registrar.pass(std::make_unique<RadianceMapsPass>(plan, settings));
        registrar.pass(std::make_unique<ScatterMapsPass>(plan, settings));
        registrar.pass(std::make_unique<PaintMixPass>(plan, settings));
    }
};

}  // namespace tyndall::translucency

TYNDALL_MODULE(tyndall::translucency::Translucency, "0.1",
               "Marble, wax, milk: light that enters a solid in one place and leaves it in another.", "")
