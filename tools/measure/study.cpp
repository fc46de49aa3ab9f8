#include "measure/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.h"
#include "core/paths.h"
#include "image/comparison.h"
#include "scene/field_reader.h"

namespace tyndall::measure {
namespace {

std::string name_of(const Sweep& sweep) {
    return sweep.name.empty() ? sweep.set.substr(sweep.set.rfind('/') + 1) : sweep.name;
}

/// The runs of a technique on a scene: each extended by each value of one more sweep.
std::vector<Run> extended(const std::vector<Run>& runs, const Sweep& sweep) {
    std::vector<std::string> values = sweep.texts;
    for (const float value : sweep.values) values.push_back(fmt::format("{}", value));
    const std::string name = name_of(sweep);
    std::vector<Run> all;
    for (const Run& run : runs)
        for (const std::string& value : values) {
            Run next = run;
            next.set.push_back(sweep.set + "=" + value);
            next.parameters.emplace_back(name, value);
            all.push_back(std::move(next));
        }
    return all;
}

void append(std::vector<std::string>& to, const std::vector<std::string>& more) {
    to.insert(to.end(), more.begin(), more.end());
}

std::vector<Run> runs_of(const StudyScene& scene, const Technique& technique) {
    Run first{&scene, &technique, {}, scene.set, scene.size, false};
    append(first.set, technique.set);
    std::vector<Run> runs;
    for (const StudyPoint& point : technique.points) {
        Run run = first;
        append(run.set, point.set);
        run.parameters.emplace_back(technique.points_are, point.name);
        if (point.size != glm::vec2(0.0f)) run.size = point.size;
        runs.push_back(std::move(run));
    }
    if (technique.points.empty()) runs.push_back(first);
    for (const Sweep& sweep : technique.sweep) runs = extended(runs, sweep);
    for (Run& run : runs)
        for (std::string& change : run.set)
            for (const StudyWord& word : scene.words)
                if (change.starts_with("{" + word.name + "}")) change.replace(0, word.name.size() + 2, word.text);
    return runs;
}

bool named(const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
}

/// Collects problems of the study as a whole; pointers say where.
class Check {
 public:
    Check(const Study& study, std::vector<Diagnostic>& problems) : study_(study), problems_(problems) {}

    void all() {
        if (study_.scenes.empty()) add("/scenes", "no scene is named", "a list of scenes");
        if (study_.techniques.empty()) add("/techniques", "no technique is named", "a list of techniques");
        names("/scenes", study_.scenes);
        names("/techniques", study_.techniques);
        for (size_t i = 0; i < study_.scenes.size(); ++i) scene(fmt::format("/scenes/{}", i), study_.scenes[i]);
        for (size_t i = 0; i < study_.techniques.size(); ++i)
            technique(fmt::format("/techniques/{}", i), study_.techniques[i]);
        baseline();
        if (study_.plots.empty()) add("/plots", "nothing is plotted", "metrics, such as relmse");
        for (size_t i = 0; i < study_.plots.size(); ++i) plot(fmt::format("/plots/{}", i), study_.plots[i]);
        for (size_t i = 0; i < study_.against.size(); ++i) against(fmt::format("/against/{}", i), study_.against[i]);
        if (problems_.empty() && runs() > static_cast<double>(kMaxRuns))
            add("/techniques", fmt::format("the study has {:.0f} runs", runs()), fmt::format("at most {}", kMaxRuns));
    }

 private:
    void add(std::string pointer, std::string message, std::string expected = {}, std::string suggestion = {}) {
        problems_.push_back(
            {{{}, 0, 0, std::move(pointer)}, std::move(message), std::move(expected), std::move(suggestion)});
    }

    template <class Named>
    void names(const std::string& pointer, const std::vector<Named>& list) {
        std::set<std::string> known;
        for (size_t i = 0; i < list.size(); ++i) {
            const std::string at = fmt::format("{}/{}/name", pointer, i);
            if (list[i].name.empty()) add(at, "has no name", "a name of its own");
            if (!list[i].name.empty() && !known.insert(list[i].name).second)
                add(at, "two are named '" + list[i].name + "'", "a name of its own");
        }
    }

    void changes(const std::string& pointer, const std::vector<std::string>& set) {
        for (size_t i = 0; i < set.size(); ++i)
            if (!is_pointer(set[i]) || set[i].find('=') == std::string::npos)
                add(fmt::format("{}/{}", pointer, i), "'" + set[i] + "' is no assignment",
                    "/json/pointer=value, such as /render/path=\"deferred\"");
    }

    /// "/a/b", or "{word}/b"; words are known where a technique's scenes are.
    static bool is_pointer(const std::string& text) { return text.starts_with('/') || text.starts_with('{'); }

    /// Words of a technique's changes that one of its scenes does not have.
    void words(const std::string& pointer, const Technique& technique) {
        for (const StudyScene& scene : study_.scenes) {
            if (!technique.scenes.empty() && !named(technique.scenes, scene.name)) continue;
            for (const Run& run : runs_of(scene, technique))
                for (const std::string& change : run.set)
                    if (change.starts_with('{'))
                        return add(pointer,
                                   fmt::format("'{}' has a word that scene '{}' does not explain", change, scene.name),
                                   "a name from the scene's \"words\"");
        }
    }

    void scene(const std::string& pointer, const StudyScene& scene) {
        if (const auto file = study_.file.parent_path() / scene.scene; !std::filesystem::is_regular_file(file))
            add(pointer + "/scene",
                scene.scene.empty() ? "no scene file is named" : "there is no file " + file.string(),
                "a scene file, relative to the study");
        if (scene.size != glm::floor(scene.size)) add(pointer + "/size", "is no whole number of pixels");
        changes(pointer + "/set", scene.set);
        changes(pointer + "/subtract", scene.subtract);
        changes(pointer + "/reference/set", scene.reference.set);
        changes(pointer + "/reference/subtract", scene.reference.subtract);
        if (scene.reference.max_order >= 0 && scene.reference.min_order > scene.reference.max_order)
            add(pointer + "/reference/max_order", "is below min_order", "at least it, or -1");
    }

    void technique(const std::string& pointer, const Technique& technique) {
        changes(pointer + "/set", technique.set);
        names(pointer + "/points", technique.points);
        for (size_t i = 0; i < technique.points.size(); ++i) {
            const StudyPoint& point = technique.points[i];
            changes(fmt::format("{}/points/{}/set", pointer, i), point.set);
            if (study_.compare && point.size != glm::vec2(0.0f))
                add(fmt::format("{}/points/{}/size", pointer, i), "another size cannot be compared",
                    "\"compare\": false in the study");
            else if (point.size != glm::floor(point.size) || (point.size.x == 0) != (point.size.y == 0))
                add(fmt::format("{}/points/{}/size", pointer, i), "is no whole number of pixels");
        }
        for (size_t i = 0; i < technique.sweep.size(); ++i)
            sweep(fmt::format("{}/sweep/{}", pointer, i), technique.sweep[i]);
        std::vector<std::string> known;
        for (const StudyScene& scene : study_.scenes) known.push_back(scene.name);
        for (size_t i = 0; i < technique.scenes.size(); ++i)
            if (const std::string& name = technique.scenes[i]; std::ranges::find(known, name) == known.end())
                add(fmt::format("{}/scenes/{}", pointer, i), "unknown scene '" + name + "'", "a name from /scenes",
                    nearest_name(name, known));
        if (problems_.empty()) words(pointer, technique);
    }

    void sweep(const std::string& pointer, const Sweep& sweep) {
        if (!is_pointer(sweep.set))
            add(pointer + "/set", "'" + sweep.set + "' is no JSON pointer",
                "such as /render/participating_media/steps");
        if (sweep.values.empty() == sweep.texts.empty())
            add(pointer, sweep.values.empty() ? "has no values" : "has both 'values' and 'texts'",
                "either 'values' or 'texts'");
    }

    void baseline() {
        if (study_.baseline.empty()) return;
        std::vector<std::string> known;
        for (const Technique& technique : study_.techniques) known.push_back(technique.name);
        const auto found = std::ranges::find(known, study_.baseline);
        if (found == known.end())
            return add("/baseline", "unknown technique '" + study_.baseline + "'", "a name from /techniques",
                       nearest_name(study_.baseline, known));
        const Technique& baseline = study_.techniques[static_cast<size_t>(found - known.begin())];
        if (!baseline.sweep.empty() || !baseline.points.empty() || !baseline.scenes.empty())
            add("/baseline", "'" + study_.baseline + "' has points, sweeps or scenes",
                "a technique of one run on every scene");
    }

    void against(const std::string& pointer, const std::string& name) {
        std::vector<std::string> known;
        for (const Technique& technique : study_.techniques) {
            if (!technique.points_are.empty()) known.push_back(technique.points_are);
            for (const Sweep& sweep : technique.sweep) known.push_back(name_of(sweep));
        }
        if (!named(known, name))
            add(pointer, "no technique has a parameter '" + name + "'", "a sweep's name or a 'points_are'",
                nearest_name(name, known));
    }

    void plot(const std::string& pointer, const std::string& name) {
        try {
            const Metric& metric = metric_called(name.starts_with("frame_") ? name.substr(6) : name);
            if (metric.at_least) add(pointer, "more of '" + name + "' is better", "a metric of which less is");
        } catch (const Error& error) {
            add(pointer, error.what());
        }
    }

    [[nodiscard]] double runs() const {
        double all = 0;
        for (const Technique& technique : study_.techniques) {
            double of_one = std::max<double>(1.0, static_cast<double>(technique.points.size()));
            for (const Sweep& sweep : technique.sweep)
                of_one *= static_cast<double>(sweep.values.size() + sweep.texts.size());
            all +=
                of_one * static_cast<double>(technique.scenes.empty() ? study_.scenes.size() : technique.scenes.size());
        }
        return all;
    }

    const Study& study_;
    std::vector<Diagnostic>& problems_;
};

}  // namespace

Study load_study(const std::filesystem::path& file) {
    Study study;
    study.file = file;
    std::vector<Diagnostic> problems;
    const JsonDocument document = parse_json(paths::read_file(file), file.string());
    Problems found(document, problems);
    read_struct(*describe_struct<Study>("study"), &study, document.root, found);
    if (problems.empty()) Check(study, problems).all();
    for (Diagnostic& problem : problems) problem.where.file = file.string();
    if (!problems.empty()) throw Error(std::move(problems));
    return study;
}

std::string Run::label() const {
    std::string text = technique->name;
    for (const auto& [name, value] : parameters) text += ", " + (name.empty() ? "" : name + " ") + value;
    return text;
}

std::vector<Run> runs_of(const Study& study, const std::vector<std::string>& only) {
    std::vector<std::string> scenes, techniques, known;
    for (const StudyScene& scene : study.scenes) known.push_back(scene.name);
    for (const std::string& name : only) (named(known, name) ? scenes : techniques).push_back(name);
    for (const Technique& technique : study.techniques) known.push_back(technique.name);
    for (const std::string& name : techniques)
        if (!named(known, name))
            throw Error(Diagnostic{{study.file.string()},
                                   "has no scene or technique '" + name + "'",
                                   join_names(known),
                                   nearest_name(name, known)});
    std::vector<Run> all;
    for (const StudyScene& scene : study.scenes) {
        if (!scenes.empty() && !named(scenes, scene.name)) continue;
        for (const bool baseline : {true, false})
            for (const Technique& technique : study.techniques) {
                if (baseline != (technique.name == study.baseline)) continue;
                if (!technique.scenes.empty() && !named(technique.scenes, scene.name)) continue;
                if (!baseline && !techniques.empty() && !named(techniques, technique.name)) continue;
                for (Run& run : runs_of(scene, technique)) {
                    run.baseline = baseline;
                    all.push_back(std::move(run));
                }
            }
    }
    return all;
}

}  // namespace tyndall::measure
