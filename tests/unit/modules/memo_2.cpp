// Version 2 of the module "memo": "text", "paper/age_a" and "shape/round/blur_m" have gone, "colour" and
// "paper/length_mm" have come, "mark" has become a text; the component "stamp" and the setting "chalk" have gone,
// "pencil" has come.

#include "module/module.h"

namespace tyndall::memo {

struct Round {
    float radius_m = 1.0f;
};
struct Square {
    float edge_m = 1.0f;
};
struct Paper {
    float weight_g = 80.0f;
    float length_mm = 297.0f;
};

struct Memo {
    static constexpr std::string_view kName = "memo";
    glm::vec3 colour{0.25f};
    float size = 1.0f;
    std::string mark = "none";
    Paper paper;
    std::variant<Round, Square> shape;
};
struct MemoSettings {
    static constexpr std::string_view kName = "memos";
    float ink = 1.0f;
    float pencil = 4.0f;
};

inline void describe(StructBuilder<Round>& d) {
    d.field("radius_m", &Round::radius_m, "Radius.").unit("m");
}
inline void describe(StructBuilder<Square>& d) {
    d.field("edge_m", &Square::edge_m, "Edge.").unit("m");
}
inline void describe(StructBuilder<Paper>& d) {
    d.field("weight_g", &Paper::weight_g, "Weight.").unit("g");
    d.field("length_mm", &Paper::length_mm, "Length.").unit("mm");
}
inline void describe(StructBuilder<Memo>& d) {
    d.field("colour", &Memo::colour, "Colour.").colour();
    d.field("size", &Memo::size, "Size.").range(0, 100);
    d.field("mark", &Memo::mark, "Mark, a text here.");
    d.field("paper", &Memo::paper, "Paper.");
    d.field("shape", &Memo::shape, "Shape.", {"round", "square"});
}
inline void describe(StructBuilder<MemoSettings>& d) {
    d.field("ink", &MemoSettings::ink, "Ink.");
    d.field("pencil", &MemoSettings::pencil, "Pencil.");
}

class MemoModule final : public Module {
 public:
    void install(Registrar& registrar) override {
        registrar.component<Memo>([](const ExtractContext&, const void*, RenderScene&) {});
        registrar.settings<MemoSettings>();
    }
};

}  // namespace tyndall::memo

TYNDALL_MODULE(tyndall::memo::MemoModule, "2", "Keeps coloured notes.", "")
