#pragma once
/// A study: techniques with their parameters on scenes, to be timed and held against traced references.

#include <filesystem>
#include <glm/vec2.hpp>
#include <string>
#include <utility>
#include <vector>

#include "ecs/description.h"

namespace tyndall::measure {

/// What a scene's pictures are held against: a film that is traced (and kept), or a file.
struct Reference {
    int32_t spp = 256;
    int32_t min_order = 0;
    int32_t max_order = -1;  ///< negative = all
    bool surfaces = true;
    bool media = true;
    std::vector<std::string> set;
    std::vector<std::string> subtract;
    std::string file;     ///< in place of a trace; "references:NAME", or relative to the study
    float noise = -1.0f;  ///< of a file without a variance; negative = unknown
};
void describe(StructBuilder<Reference>& d);

/// What a technique's changes mean by {name} on a scene.
struct StudyWord {
    std::string name, text;
};
void describe(StructBuilder<StudyWord>& d);

/// A scene and how its pictures are taken.
struct StudyScene {
    std::string name;
    std::string doc;
    std::string scene;
    std::string camera;
    glm::vec2 size{320.0f, 180.0f};
    int32_t supersample = 4;
    int32_t frames = 1;
    std::vector<StudyWord> words;
    std::vector<std::string> set;
    std::vector<std::string> subtract;
    Reference reference;
};
void describe(StructBuilder<StudyScene>& d);

/// One value after the other at one place of the scene file.
struct Sweep {
    std::string name;                ///< empty = the last part of `set`
    std::string set;                 ///< JSON pointer
    std::vector<float> values;       ///< numbers ...
    std::vector<std::string> texts;  ///< ... or any JSON
};
void describe(StructBuilder<Sweep>& d);

/// Parameters that were chosen by hand.
struct StudyPoint {
    std::string name;
    glm::vec2 size{0.0f};  ///< of the picture; 0 = the scene's
    std::vector<std::string> set;
};
void describe(StructBuilder<StudyPoint>& d);

/// A way to render: each of its points with each combination of its sweeps' values is a run.
struct Technique {
    std::string name;
    std::string doc;
    std::vector<std::string> set;
    std::vector<std::string> scenes;  ///< empty = all
    std::string refused_if;           ///< what the log says where it is not rendered so
    std::string points_are;           ///< what the points' names are values of, such as "lights"
    std::vector<StudyPoint> points;   ///< empty = one without changes
    std::vector<Sweep> sweep;
};
void describe(StructBuilder<Technique>& d);

/// How runs are timed.
struct StudyBench {
    int32_t frames = 20;
    int32_t warmup = 3;
};
void describe(StructBuilder<StudyBench>& d);

/// Which clock the plots and the front go by.
enum class Clock { frame, processor };

/// The content of a study file.
struct Study {
    int32_t tyndall_study = 1;
    std::string title;
    std::string doc;
    std::vector<StudyScene> scenes;
    std::vector<Technique> techniques;
    std::string baseline;
    Clock clock = Clock::frame;
    std::vector<std::string> plots{"relmse"};
    std::vector<std::string> against;  ///< parameters over which time is plotted
    bool compare = true;               ///< off: runs are timed, and there are no references
    StudyBench bench;
    std::filesystem::path file;  ///< where it was read from

    [[nodiscard]] std::string name() const { return file.stem().string(); }
};
void describe(StructBuilder<Study>& d);

/// Reads and checks a study. Throws Error with every problem.
[[nodiscard]] Study load_study(const std::filesystem::path& file);

/// One picture to be made: a scene, a technique, and its parameters.
struct Run {
    const StudyScene* scene = nullptr;  ///< these two are the study's
    const Technique* technique = nullptr;
    std::vector<std::pair<std::string, std::string>> parameters;  ///< name and value, for people
    std::vector<std::string> set;  ///< all changes: of the scene, the technique, the point and the sweeps
    glm::vec2 size{0.0f};          ///< of what is timed
    bool baseline = false;         ///< is timed and not compared

    /// "full, steps 8"
    [[nodiscard]] std::string label() const;
};

/// The most runs of a study.
inline constexpr size_t kMaxRuns = 10000;

/// All runs, scene by scene, the baseline first. `only` (empty = all) are names of scenes and of techniques: a run is
/// left out when scenes are named and its own is not, or techniques are and its own is not; the baseline stays. Throws
/// Error for an unknown name.
[[nodiscard]] std::vector<Run> runs_of(const Study& study, const std::vector<std::string>& only = {});

}  // namespace tyndall::measure
