#pragma once
/// The errors that an earlier run of a study wrote as JSON: pictures do not change with the machine, times do.

#include <filesystem>
#include <string>

#include "measure/results.h"

namespace tyndall {

class EarlierErrors {
 public:
    /// Throws Error when the file is not what `tyndall measure --json` writes.
    explicit EarlierErrors(const std::filesystem::path& file);

    /// Takes over what the scene was held against.
    void fill(measure::SceneResults& scene) const;
    /// Takes over a run's errors. Throws Error when they are not there.
    void fill(const std::string& scene, const std::string& label, measure::Row& row) const;
    /// The program that made the pictures.
    [[nodiscard]] const std::string& program() const { return program_; }

 private:
    [[nodiscard]] const measure::SceneResults& scene(const std::string& name) const;
    std::filesystem::path file_;
    std::string program_;
    std::vector<measure::SceneResults> scenes_;
};

}  // namespace tyndall
