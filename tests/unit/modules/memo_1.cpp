// Version 1 of the module "memo": see memo_2.cpp.

#include "module/module.h"

namespace tyndall::memo {

struct Round {
    float radius_m = 1.0f;
    float blur_m = 0.5f;
};
struct Square {
    float edge_m = 1.0f;
};
struct Paper {
    float weight_g = 80.0f;
    float age_a = 0.0f;
};

struct Memo {
    static constexpr std::string_view kName = "memo";
    float size = 1.0f;
    std::string text = "empty";
    int32_t mark = 3;
    Paper paper;
    std::variant<Round, Square> shape;
};
struct Stamp {
    static constexpr std::string_view kName = "stamp";
    float value = 1.0f;
};
struct MemoSettings {
    static constexpr std::string_view kName = "memos";
    float ink = 1.0f;
    float chalk = 2.0f;
};

inline void describe(StructBuilder<Round>& d) {
    d.field("radius_m", &Round::radius_m, "Radius.").unit("m");
    d.field("blur_m", &Round::blur_m, "Blur.").unit("m");
}
inline void describe(StructBuilder<Square>& d) {
    d.field("edge_m", &Square::edge_m, "Edge.").unit("m");
}
inline void describe(StructBuilder<Paper>& d) {
    d.field("weight_g", &Paper::weight_g, "Weight.").unit("g");
    d.field("age_a", &Paper::age_a, "Age.").unit("a");
}
inline void describe(StructBuilder<Memo>& d) {
    d.field("size", &Memo::size, "Size.").range(0, 100);
    d.field("text", &Memo::text, "Text.");
    d.field("mark", &Memo::mark, "Mark, a number here.");
    d.field("paper", &Memo::paper, "Paper.");
    d.field("shape", &Memo::shape, "Shape.", {"round", "square"});
}
inline void describe(StructBuilder<Stamp>& d) {
    d.field("value", &Stamp::value, "Value.");
}
inline void describe(StructBuilder<MemoSettings>& d) {
    d.field("ink", &MemoSettings::ink, "Ink.");
    d.field("chalk", &MemoSettings::chalk, "Chalk.");
}

class MemoModule final : public Module {
 public:
    void install(Registrar& registrar) override {
        registrar.component<Memo>([](const ExtractContext&, const void*, RenderScene&) {});
        registrar.component<Stamp>([](const ExtractContext&, const void*, RenderScene&) {});
        registrar.settings<MemoSettings>();
    }
};

}  // namespace tyndall::memo

TYNDALL_MODULE(tyndall::memo::MemoModule, "1", "Keeps notes.", "")
