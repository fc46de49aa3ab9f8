// One half of a circle.

#include "module/module.h"

namespace tyndall::left {

class Left final : public Module {
 public:
    void install(Registrar&) override {}
};

}  // namespace tyndall::left

TYNDALL_MODULE(tyndall::left::Left, "1", "Depends on right.", "right")
