// What each kind of broken module is told, and what depends on what.

#include <gmock/gmock.h>

#include <chrono>
#include <thread>

#include "module_fixture.h"
#include "scene/scene_file.h"

namespace tyndall {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class ModuleTest : public testing::Test {
 protected:
    void put(const std::string& generation, const std::string& name = "memo") { put_module(folder_, generation, name); }
    void write(const std::string& file, const std::string& content) {
        std::ofstream(folder_ / file, std::ios::binary) << content;
    }
    ModuleReport report(const std::string& name) {
        for (const ModuleReport& report : manager().reports())
            if (report.name == name) return report;
        ADD_FAILURE() << "no report of " << name;
        return {};
    }
    ModuleManager& manager() {
        if (!manager_) manager_ = std::make_unique<ModuleManager>(stage_.host(), folder_, folder_);
        return *manager_;
    }
    /// A module that cannot be loaded: its state and the message.
    void expect_refused(const std::string& name, ModuleState state, const std::string& message) {
        EXPECT_FALSE(manager().load(name));
        EXPECT_EQ(name_of(report(name).state), name_of(state)) << name;
        EXPECT_THAT(report(name).problem, HasSubstr(message));
        EXPECT_FALSE(manager().loaded(name));
        EXPECT_THAT(stage_.registry.names(), testing::Not(testing::Contains("half")));
        EXPECT_EQ(mappings_of(name), 0) << "not unmapped";
    }

    TemporaryFolder temporary_;
    const std::filesystem::path folder_ = temporary_.path();
    ModuleStage stage_;
    std::unique_ptr<ModuleManager> manager_;
};

TEST_F(ModuleTest, AModuleBringsWhatItRegistersAndTakesItAway) {
    put("1");
    EXPECT_EQ(report("memo").state, ModuleState::available);
    ASSERT_TRUE(manager().load("memo"));
    const ModuleReport loaded = report("memo");
    EXPECT_EQ(loaded.state, ModuleState::loaded);
    EXPECT_EQ(loaded.version, "1");
    EXPECT_EQ(loaded.summary, "Keeps notes.");
    EXPECT_THAT(loaded.components, ElementsAre("memo", "stamp"));
    EXPECT_THAT(loaded.settings, ElementsAre("memos"));
    EXPECT_EQ(stage_.registry.owner(stage_.registry.find("memo")), "memo");
    EXPECT_GT(mappings_of("memo"), 0);
    manager().unload("memo");
    EXPECT_EQ(report("memo").state, ModuleState::available);
    EXPECT_EQ(stage_.registry.find("memo"), ComponentId::none);
    EXPECT_EQ(stage_.settings.type("memos"), nullptr);
    EXPECT_EQ(mappings_of("memo"), 0);
}

TEST_F(ModuleTest, AnUnknownNameSuggestsTheNearest) {
    put("1");
    expect_refused("mema", ModuleState::not_found, "there is no module 'mema'");
    EXPECT_THAT(report("mema").problem, HasSubstr("did you mean 'memo'"));
}

TEST_F(ModuleTest, NamesAreNoPaths) {
    put("1");
    for (const std::string name : {"../memo", "/memo", "memo.so", "", "Memo"})
        expect_refused(name, ModuleState::not_found, "is no module name");
}

TEST_F(ModuleTest, FilesThatAreNoModules) {
    write("text.so", "This is not a library.\n");
    expect_refused("text", ModuleState::wrong_interface, "text.so: is no shared library");
    write("nothing.so", "");
    expect_refused("nothing", ModuleState::wrong_interface, "nothing.so: is no shared library");
    put("without_entry_points");
    expect_refused("memo", ModuleState::wrong_interface, "no entry point 'tyndall_module_info'");
}

TEST_F(ModuleTest, ATruncatedLibraryIsRefusedAtAnyLength) {
    const std::string whole = paths::read_file(test_modules() / "1" / "memo.so");
    for (const size_t length : {size_t{5}, size_t{63}, size_t{64}, size_t{1000}, size_t{5000}, whole.size() / 4,
                                whole.size() / 2, whole.size() - 1}) {
        write("memo.so", whole.substr(0, length));
        expect_refused("memo", ModuleState::wrong_interface, "is cut short after " + std::to_string(length));
    }
    write("memo.so", whole);
    EXPECT_TRUE(manager().load("memo"));
}

TEST_F(ModuleTest, AnotherAbiOrNameIsRefused) {
    put("other_abi");
    expect_refused("memo", ModuleState::wrong_interface, "another engine (ABI 0123456789abcdef, this program has");
    put("other_name");
    expect_refused("memo", ModuleState::wrong_interface, "calls itself 'diary'");
}

TEST_F(ModuleTest, WhatItThrowsIsToldAndNothingOfItStays) {
    put("throws_in_install");
    expect_refused("memo", ModuleState::failed, "install threw: out of ink");
    put("throws_in_constructor");
    expect_refused("memo", ModuleState::failed, "its constructor threw: something that is no std::exception");
}

TEST_F(ModuleTest, DependenciesComeFirstAndTakeTheirDependantsAlong) {
    put("1", "reader");
    expect_refused("reader", ModuleState::unresolved_dependency, "it needs the module 'memo', which cannot be loaded");
    put("1");
    ASSERT_TRUE(manager().load("reader"));
    EXPECT_THAT(manager().in_use(), ElementsAre("memo", "reader"));
    EXPECT_THAT(report("reader").depends, ElementsAre("memo"));
    manager().unload("memo");
    EXPECT_THAT(manager().in_use(), IsEmpty());
    EXPECT_EQ(mappings_of("reader"), 0);
}

TEST_F(ModuleTest, CirclesAreFound) {
    put("1", "left");
    put("1", "right");
    expect_refused("left", ModuleState::unresolved_dependency, "it needs the module 'right'");
    EXPECT_THAT(report("right").problem, HasSubstr("in a circle through 'left'"));
    put("1");
    put("1", "reader");
    ASSERT_TRUE(manager().load("reader"));
    put("needs_reader");
    EXPECT_FALSE(manager().reload("memo"));
    EXPECT_EQ(report("memo").state, ModuleState::outdated);
    EXPECT_THAT(report("memo").problem, HasSubstr("in a circle through 'reader'"));
    EXPECT_EQ(report("memo").version, "1");
}

TEST_F(ModuleTest, ABrokenOneIsTriedAgainWhenItsFileChanges) {
    put("throws_in_install");
    put("1", "reader");
    EXPECT_FALSE(manager().load("reader"));
    put("1");
    std::vector<std::string> reloaded;
    for (int i = 0; i < 50 && reloaded.empty(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        reloaded = manager().reload_changed();
    }
    EXPECT_THAT(reloaded, ElementsAre("memo", "reader"));
    EXPECT_EQ(report("reader").problem, "");
}

TEST_F(ModuleTest, ALoadedModuleOfPassesAloneIsNotMissing) {
    put("1", "left");
    const SceneFile scene = SceneFile::parse(
        R"({ "tyndall": 1, "modules": ["left"], "entities": [{ "name": "A", "memmo": {} }] })", "scene.json");
    EXPECT_THAT(scene.validate(stage_.registry, stage_.settings), IsEmpty()) << "it may be the absent module's";
    const std::vector<std::string> loaded{"left"};
    const std::vector<Diagnostic> problems = scene.validate(stage_.registry, stage_.settings, loaded);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_THAT(problems[0].text(), HasSubstr("unknown component 'memmo'"));
}

}  // namespace
}  // namespace tyndall
