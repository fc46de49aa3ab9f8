// A file called memo.so with another module in it.

#include "module/module.h"

#undef TYNDALL_MODULE_NAME
#define TYNDALL_MODULE_NAME "diary"

namespace tyndall::memo {

class Diary final : public Module {
 public:
    void install(Registrar&) override {}
};

}  // namespace tyndall::memo

TYNDALL_MODULE(tyndall::memo::Diary, "3", "Something else.", "")
