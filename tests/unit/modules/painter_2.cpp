#include "painter.h"

namespace tyndall::painter {

class Painter final : public Module {
 public:
    void install(Registrar& registrar) override { install_painter(registrar, {0.0f, 1.0f, 8.0f}); }
};

}  // namespace tyndall::painter

TYNDALL_MODULE(tyndall::painter::Painter, "2", "Paints.", "")
