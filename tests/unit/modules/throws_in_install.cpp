// A build of "memo" that throws an exception of its own type when half of it is registered.

#include "module/module.h"

namespace tyndall::memo {

struct OutOfInk : std::exception {
    [[nodiscard]] const char* what() const noexcept override { return "out of ink"; }
};
struct Half {
    static constexpr std::string_view kName = "half";
    float value = 1.0f;
};
inline void describe(StructBuilder<Half>& d) {
    d.field("value", &Half::value, "Value.");
}

class MemoModule final : public Module {
 public:
    void install(Registrar& registrar) override {
        registrar.component<Half>([](const ExtractContext&, const void*, RenderScene&) {});
        throw OutOfInk();
    }
};

}  // namespace tyndall::memo

TYNDALL_MODULE(tyndall::memo::MemoModule, "3", "Fails.", "")
