// A build of "memo" whose object cannot be made; it throws something that is no std::exception.

#include "module/module.h"

namespace tyndall::memo {

class MemoModule final : public Module {
 public:
    MemoModule() { throw 42; }
    void install(Registrar&) override {}
};

}  // namespace tyndall::memo

TYNDALL_MODULE(tyndall::memo::MemoModule, "3", "Fails.", "")
