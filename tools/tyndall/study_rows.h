#pragma once
/// Finished rows of a study that was interrupted, kept until the study is done.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "image/image.h"
#include "measure/results.h"

namespace tyndall {

/// A row with its picture, which a baseline has not.
struct MeasuredRow {
    measure::Row row;
    Image picture;
};

/// A folder of rows by keys.
class StudyRows {
 public:
    explicit StudyRows(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// The row that was kept under this key; nothing where there is none or it cannot be read.
    [[nodiscard]] std::optional<MeasuredRow> find(const std::string& key);
    /// Throws Error when it cannot be written.
    void keep(const std::string& key, const MeasuredRow& row);
    /// Forgets the rows that were found and kept, and the folder when nothing else is in it: the study is done.
    void forget();

 private:
    [[nodiscard]] std::filesystem::path file(const std::string& key, const char* extension) const;
    std::filesystem::path folder_;
    std::vector<std::string> used_;
};

}  // namespace tyndall
