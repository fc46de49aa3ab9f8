#include "gpu/shader_library.h"

#include <optional>
#include <unordered_map>

#include "core/log.h"
#include "core/paths.h"
#include "gpu/shader_compile.h"

namespace tyndall::gpu {
namespace fs = std::filesystem;
namespace {

struct Entry {
    Program program;             // name() is 0 while it has never compiled
    ShaderReads reads;           // of the newest attempt
    std::optional<Error> error;  // of the newest attempt
    bool stale = true;
};

struct DescHash {
    size_t operator()(const ProgramDesc& desc) const {
        size_t hash = 0;
        const auto mix = [&hash](const std::string& text) { hash = hash * 31 + std::hash<std::string>{}(text); };
        for (const std::string* text : {&desc.name, &desc.vertex, &desc.geometry, &desc.fragment, &desc.compute})
            mix(*text);
        for (const std::string& define : desc.defines) mix(define);
        return hash;
    }
};

}  // namespace

struct ShaderLibrary::Implementation {
    ShaderFiles files{paths::root() / "engine"};
    std::unordered_map<ProgramDesc, std::unique_ptr<Entry>, DescHash> entries;  // pointers: references stay valid

    /// Builds the entry anew; what fails keeps the last good program.
    void build(const ProgramDesc& desc, Entry& entry) const {
        entry.stale = false;
        ShaderReads reads;
        try {
            entry.program = compile(files, desc, reads);
            entry.error.reset();
        } catch (const Error& error) {
            entry.error = error;
            if (entry.program.name() != 0) log::error("{}\nthe last good version of it stays", error.what());
        }
        entry.reads = std::move(reads);
    }

    void mark_stale(const auto& matches) {
        for (auto& [desc, entry] : entries)
            for (const auto& [name, text] : entry->reads)
                if (matches(name)) entry->stale = true;
    }
};

ShaderLibrary::ShaderLibrary() : self_(std::make_unique<Implementation>()) {}

ShaderLibrary::~ShaderLibrary() {
    release_samplers();
}

void ShaderLibrary::add_folder(const std::string& prefix, const fs::path& folder) {
    self_->files.add_folder(prefix, folder);
    self_->mark_stale([&](const std::string& name) { return name.starts_with(prefix + "/"); });
}

void ShaderLibrary::remove_folder(const std::string& prefix) {
    self_->files.remove_folder(prefix);
}

void ShaderLibrary::set_text(const std::string& name, std::string text) {
    if (self_->files.set_text(name, std::move(text)))
        self_->mark_stale([&](const std::string& read) { return read == name; });
}

const Program& ShaderLibrary::program(const ProgramDesc& desc) {
    std::unique_ptr<Entry>& entry = self_->entries[desc];
    if (!entry) entry = std::make_unique<Entry>();
    if (entry->stale) self_->build(desc, *entry);
    if (entry->program.name() == 0) throw Error(*entry->error);
    return entry->program;
}

void ShaderLibrary::drop(std::string_view prefix) {
    std::erase_if(self_->entries, [&](const auto& entry) { return entry.first.name.starts_with(prefix); });
}

int ShaderLibrary::reload_changed() {
    std::unordered_map<std::string, fs::file_time_type> times;  // programs share files: ask for each once
    const auto changed = [&](const ShaderText& text) {
        if (text.file.empty()) return false;
        const auto [time, is_new] = times.try_emplace(text.file.string());
        if (is_new) time->second = modified_time(text.file);
        return time->second != text.modified;
    };
    int rebuilt = 0;
    for (auto& [desc, entry] : self_->entries) {
        bool any = false;
        for (const auto& [name, text] : entry->reads) any = any || changed(text);
        if (!any) continue;
        self_->build(desc, *entry);
        rebuilt += entry->error ? 0 : 1;
    }
    return rebuilt;
}

std::string ShaderLibrary::broken() const {
    std::string out;
    for (const auto& [desc, entry] : self_->entries)
        if (entry->error) out += std::string(out.empty() ? "" : "\n") + entry->error->what();
    return out;
}

}  // namespace tyndall::gpu
