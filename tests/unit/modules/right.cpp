// The other half of a circle.

#include "module/module.h"

namespace tyndall::right {

class Right final : public Module {
 public:
    void install(Registrar&) override {}
};

}  // namespace tyndall::right

TYNDALL_MODULE(tyndall::right::Right, "1", "Depends on left.", "left")
