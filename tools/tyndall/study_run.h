#pragma once
/// Running a study: references, times, pictures and how far they are off.

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "measure/results.h"
#include "platform/context.h"
#include "study_earlier.h"
#include "study_rows.h"
#include "study_truth.h"

namespace tyndall {

/// How a study is run.
struct StudyOptions {
    std::filesystem::path cache;                   ///< for films, and for the rows of a run that was interrupted
    std::vector<std::string> only;                 ///< names of scenes and techniques; empty = all
    bool restart = false;                          ///< measures again what an interrupted run had finished
    std::shared_ptr<const EarlierErrors> earlier;  ///< errors to take over: runs are timed alone
    std::function<bool()> cancelled;               ///< asked often, from several threads
};

/// What is left in memory of a scene when it was measured.
struct MeasuredScene {
    measure::SceneResults results;
    Truth truth;
    std::vector<Image> pictures;  ///< of each row; empty where there is none
};

/// Measures all runs of a study, tells of each as it is done, and keeps those that are done when it is cancelled.
class StudyRun {
 public:
    /// Throws Error for unknown names in `only`.
    StudyRun(const measure::Study& study, const StudyOptions& options);
    ~StudyRun();

    /// False when it was cancelled. What fails for one run, or for a scene, is in its rows.
    [[nodiscard]] bool all();

    [[nodiscard]] const std::vector<MeasuredScene>& scenes() const { return scenes_; }
    [[nodiscard]] measure::Results results() const;
    /// Rows without numbers.
    [[nodiscard]] int failed() const { return failed_; }

 private:
    bool measure_scene(const measure::StudyScene& scene);
    /// The scene's reference in `into`; the problem, where there is none. False when it was cancelled.
    bool find_truth(const measure::StudyScene& scene, MeasuredScene& into, std::string& problem);
    [[nodiscard]] MeasuredRow measured(const measure::Run& run, Engine& engine, const Truth& truth) const;
    void time(const measure::Run& run, Engine& engine, measure::Row& row) const;
    void compare(const measure::Run& run, Engine& engine, const Truth& truth, MeasuredRow& row) const;
    [[nodiscard]] std::string key_of(const measure::Run& run, const Truth& truth) const;
    void keep(const std::string& key, const MeasuredRow& row);
    void tell(const measure::Row& row, bool kept);
    [[nodiscard]] TraceWatch watch(const std::string& scene) const;

    const measure::Study& study_;
    const StudyOptions& options_;
    std::vector<measure::Run> runs_;
    FilmCache films_;
    StudyRows rows_;
    std::unique_ptr<platform::Context> context_;
    std::vector<MeasuredScene> scenes_;
    size_t done_ = 0;
    int failed_ = 0;
    bool warned_ = false;  ///< that rows cannot be kept
};

}  // namespace tyndall
