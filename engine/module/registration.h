#pragma once
/// What one module registered, and taking it back.

#include <string>
#include <utility>
#include <vector>

#include "module/module.h"

namespace tyndall {

class Renderer;

/// The engine's rooms that modules furnish. `renderer` is null where nothing is drawn (schema, validation, path
/// tracer).
struct ModuleHost {
    ComponentRegistry& components;
    Extractors& extractors;
    Settings& settings;
    std::vector<World*> worlds;
    Renderer* renderer = nullptr;
};

/// A Registrar that remembers. Destroying it takes everything back: passes, seams, extractors, settings, and the
/// components with their values in all worlds.
class Registration final : public Registrar {
 public:
    Registration(ModuleHost& host, std::string owner) : host_(host), owner_(std::move(owner)) {}
    ~Registration() override;

    void pass(std::unique_ptr<Pass> pass) override;
    void seam(Seam seam, SeamProvider provider) override;

    [[nodiscard]] const std::vector<std::string>& components() const { return components_; }
    [[nodiscard]] const std::vector<std::string>& settings_names() const { return settings_; }
    [[nodiscard]] std::vector<std::string> passes() const;
    [[nodiscard]] std::vector<std::string> seams() const;

 private:
    void add_component(std::shared_ptr<const StructType> type, Extractor extractor) override;
    const void* add_settings(std::shared_ptr<const StructType> type) override;

    ModuleHost& host_;
    std::string owner_;
    std::vector<std::string> components_;
    std::vector<std::string> settings_;
    std::vector<std::unique_ptr<Pass>> passes_;
    std::vector<std::pair<Seam, SeamProvider>> seams_;
};

}  // namespace tyndall
