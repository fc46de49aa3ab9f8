// A build of "memo" against other headers.

#include "module/module.h"

#undef TYNDALL_ABI_TAG
#define TYNDALL_ABI_TAG "0123456789abcdef"

namespace tyndall::memo {

class MemoModule final : public Module {
 public:
    void install(Registrar&) override {}
};

}  // namespace tyndall::memo

TYNDALL_MODULE(tyndall::memo::MemoModule, "3", "Too old.", "")
