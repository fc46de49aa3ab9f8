#include "study_rows.h"

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/log.h"
#include "core/paths.h"
#include "image/image_io.h"

namespace tyndall {
namespace fs = std::filesystem;

fs::path StudyRows::file(const std::string& key, const char* extension) const {
    return folder_ / (key + extension);
}

std::optional<MeasuredRow> StudyRows::find(const std::string& key) {
    if (!fs::exists(file(key, ".json"))) return std::nullopt;
    try {
        MeasuredRow found;
        found.row = measure::row_from_json(nlohmann::json::parse(paths::read_file(file(key, ".json"))));
        if (fs::exists(file(key, ".exr"))) found.picture = load_image(file(key, ".exr"));
        used_.push_back(key);
        return found;
    } catch (const std::exception& error) {
        log::warning("{}: a row that an earlier run left cannot be read and is measured anew: {}",
                     file(key, ".json").string(), error.what());
        return std::nullopt;
    }
}

void StudyRows::keep(const std::string& key, const MeasuredRow& row) {
    fs::create_directories(folder_);
    if (!row.picture.empty()) save_exr(file(key, ".exr"), row.picture);
    paths::write_file_atomically(file(key, ".json"), measure::to_json(row.row).dump() + "\n");
    used_.push_back(key);
}

void StudyRows::forget() {
    std::error_code ignored;
    for (const std::string& key : used_)
        for (const char* extension : {".json", ".exr"}) fs::remove(file(key, extension), ignored);
    if (fs::is_directory(folder_, ignored) && fs::is_empty(folder_, ignored)) fs::remove(folder_, ignored);
    used_.clear();
}

}  // namespace tyndall
