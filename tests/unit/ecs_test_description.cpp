// Reflection: what a description says about each kind of field, and reading and writing through it.
#include <gtest/gtest.h>

#include "ecs/component_registry.h"
#include "ecs/transform.h"

namespace tyndall {
namespace described {

enum class Mode { off = 0, soft = 1, hard = 2 };
struct Inner {
    float depth = 4;
};
struct Sphere {
    float radius = 2;
};
struct Named {
    std::string title = "untitled";
};
struct Everything {
    static constexpr std::string_view kName = "everything";
    bool on = true;
    int32_t count = 3;
    float length_m = 1.5f;
    glm::vec2 uv{1, 2};
    glm::vec3 tint{1, 2, 3};
    glm::vec4 plane{1, 2, 3, 4};
    glm::quat rotation{1, 0, 0, 0};
    std::string picture = "stone.png";
    Mode mode = Mode::soft;
    Inner inner;
    std::vector<Inner> inners;
    std::vector<float> numbers;
    std::vector<std::string> words;
    std::variant<Sphere, Named> shape;
};

void describe(StructBuilder<Inner>& d) {
    d.field("depth", &Inner::depth, "How deep.").unit("m");
}
void describe(StructBuilder<Sphere>& d) {
    d.field("radius", &Sphere::radius, "How wide.").unit("m");
}
void describe(StructBuilder<Named>& d) {
    d.field("title", &Named::title, "What it is called.");
}
void describe(StructBuilder<Everything>& d) {
    d.doc("One of each.");
    d.field("on", &Everything::on, "A switch.");
    d.field("count", &Everything::count, "A number.").range(0, 10);
    d.field("length_m", &Everything::length_m, "A length.").unit("m").range(0.5, 2.0);
    d.field("uv", &Everything::uv, "Two.");
    d.field("tint", &Everything::tint, "Three.").colour();
    d.field("plane", &Everything::plane, "Four.");
    d.field("rotation", &Everything::rotation, "A turn.");
    d.field("picture", &Everything::picture, "A file.").asset("texture");
    d.field("mode", &Everything::mode, "One of three.", {"off", "soft", "hard"});
    d.field("inner", &Everything::inner, "Nested.");
    d.field("inners", &Everything::inners, "Many nested.");
    d.field("numbers", &Everything::numbers, "Many numbers.");
    d.field("words", &Everything::words, "Many words.");
    d.field("shape", &Everything::shape, "One of two.", {"sphere", "named"});
}

}  // namespace described
namespace {

using namespace described;

class Description : public testing::Test {
 protected:
    const Field& field(std::string_view name) {
        const Field* found = type->find(name);
        if (found == nullptr) throw std::out_of_range(std::string(name));
        return *found;
    }
    template <class M>
    M& in(std::string_view name) {
        return *static_cast<M*>(field(name).in(static_cast<void*>(&object)));
    }
    std::shared_ptr<const StructType> type = describe_struct<Everything>("everything");
    Everything object;
};

TEST_F(Description, KindsOffsetsAndNotes) {
    const std::vector<FieldKind> expected{
        FieldKind::boolean, FieldKind::integer,    FieldKind::real, FieldKind::vec2,        FieldKind::vec3,
        FieldKind::vec4,    FieldKind::quaternion, FieldKind::text, FieldKind::enumeration, FieldKind::structure,
        FieldKind::list,    FieldKind::list,       FieldKind::list, FieldKind::choice};
    ASSERT_EQ(type->fields.size(), expected.size());
    for (size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(type->fields[i].kind, expected[i]) << type->fields[i].name;
    EXPECT_EQ(&in<bool>("on"), &object.on);
    EXPECT_EQ(&in<int32_t>("count"), &object.count);
    EXPECT_EQ(&in<float>("length_m"), &object.length_m);
    EXPECT_EQ(&in<glm::vec4>("plane"), &object.plane);
    EXPECT_EQ(in<std::string>("picture"), "stone.png");
    EXPECT_EQ(field("length_m").unit, "m");
    EXPECT_EQ(field("length_m").minimum, 0.5);
    EXPECT_EQ(field("length_m").maximum, 2.0);
    EXPECT_TRUE(field("tint").colour);
    EXPECT_EQ(field("picture").asset, "texture");
    EXPECT_EQ(field("on").doc, "A switch.");
    EXPECT_EQ(type->doc, "One of each.");
    EXPECT_EQ(type->size, sizeof(Everything));
    EXPECT_FALSE(type->trivial);
    EXPECT_TRUE(describe_struct<Transform>("transform")->trivial);
    EXPECT_EQ(type->find("nothing"), nullptr);
}

TEST_F(Description, EnumerationsReadAndWriteByNumber) {
    const Field& mode = field("mode");
    EXPECT_EQ(mode.names.at(size_t(mode.get_enum(&object.mode))), "soft");
    mode.set_enum(&object.mode, 2);
    EXPECT_EQ(object.mode, Mode::hard);
}

TEST_F(Description, StructuresNest) {
    const Field* depth = field("inner").type->find("depth");
    ASSERT_NE(depth, nullptr);
    *static_cast<float*>(depth->in(field("inner").in(static_cast<void*>(&object)))) = 9;
    EXPECT_EQ(object.inner.depth, 9);
}

TEST_F(Description, ListsGrowAndAreWrittenByElement) {
    const Field& inners = field("inners");
    inners.list_resize(&object.inners, 2);
    ASSERT_EQ(inners.list_size(&object.inners), 2u);
    ASSERT_EQ(inners.element->kind, FieldKind::structure);
    void* second = inners.element->in(inners.list_at(&object.inners, 1));
    *static_cast<float*>(inners.element->type->find("depth")->in(second)) = 7;
    EXPECT_EQ(object.inners[0].depth, 4);
    EXPECT_EQ(object.inners[1].depth, 7);
    EXPECT_EQ(field("numbers").element->kind, FieldKind::real);
    EXPECT_EQ(field("words").element->kind, FieldKind::text);
    field("words").list_resize(&object.words, 1);
    *static_cast<std::string*>(field("words").list_at(&object.words, 0)) = "word";
    EXPECT_EQ(object.words, std::vector<std::string>{"word"});
}

TEST_F(Description, ChoicesSwitchTheirAlternative) {
    const Field& shape = field("shape");
    ASSERT_EQ(shape.alternatives.size(), 2u);
    EXPECT_EQ(shape.alternatives[1]->name, "named");
    EXPECT_EQ(shape.choice_index(&object.shape), 0u);
    EXPECT_EQ(shape.choice_value(&object.shape), &std::get<Sphere>(object.shape));
    void* named = shape.choice_emplace(&object.shape, 1);
    EXPECT_EQ(shape.choice_index(&object.shape), 1u);
    const Field* title = shape.alternatives[1]->find("title");
    EXPECT_EQ(*static_cast<std::string*>(title->in(named)), "untitled");
    *static_cast<std::string*>(title->in(named)) = "arch";
    EXPECT_EQ(std::get<Named>(object.shape).title, "arch");
}

TEST_F(Description, ObjectsAreMadeCopiedMovedAndDestroyedUnseen) {
    alignas(Everything) std::byte memory[3][sizeof(Everything)];
    type->construct(memory[0]);
    auto& made = *std::launder(reinterpret_cast<Everything*>(memory[0]));
    EXPECT_EQ(made.count, 3);
    made.words = {"a", "b"};
    type->copy_construct(memory[1], memory[0]);
    type->move_construct(memory[2], memory[0]);
    EXPECT_EQ(std::launder(reinterpret_cast<Everything*>(memory[1]))->words.size(), 2u);
    EXPECT_EQ(std::launder(reinterpret_cast<Everything*>(memory[2]))->words.size(), 2u);
    EXPECT_TRUE(made.words.empty());
    for (std::byte* each : memory) type->destroy(each);
}

TEST_F(Description, TheEnginesOwnTypes) {
    const auto transform = describe_struct<Transform>("transform");
    ASSERT_EQ(transform->fields.size(), 3u);
    EXPECT_EQ(transform->find("translation")->unit, "m");
    EXPECT_EQ(transform->find("rotation")->kind, FieldKind::quaternion);
    EXPECT_EQ(transform->find("scale")->kind, FieldKind::vec3);
    EXPECT_TRUE(describe_struct<WorldMatrix>("world_matrix")->fields.empty());
}

}  // namespace
}  // namespace tyndall
