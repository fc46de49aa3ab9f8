// Depends on "memo".

#include "module/module.h"

namespace tyndall::reader {

class Reader final : public Module {
 public:
    void install(Registrar&) override {}
};

}  // namespace tyndall::reader

TYNDALL_MODULE(tyndall::reader::Reader, "1", "Depends on memo.", "memo")
