// A build of "memo" that depends on what depends on it.

#include "module/module.h"

namespace tyndall::memo {

class MemoModule final : public Module {
 public:
    void install(Registrar&) override {}
};

}  // namespace tyndall::memo

TYNDALL_MODULE(tyndall::memo::MemoModule, "1", "Depends on reader.", "reader")
