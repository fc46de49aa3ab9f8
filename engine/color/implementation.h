#pragma once
// OpenColorIO's types behind ColorConfig; included by the sources of this floor alone.

#include <OpenColorIO/OpenColorIO.h>
#include <algorithm>

#include "color/color.h"
#include "core/error.h"

namespace tyndall {

namespace OCIO = OCIO_NAMESPACE;

struct ColorConfig::Implementation {
    std::filesystem::path file;
    OCIO::ConstConfigRcPtr config;

    /// Runs `work`; what OpenColorIO throws becomes an Error that names the configuration.
    template <class Work>
    auto guarded(std::string_view step, Work&& work) const {
        try {
            return work();
        } catch (const Error&) {
            throw;
        } catch (const std::exception& error) {
            std::string reason = error.what();
            std::replace(reason.begin(), reason.end(), '\n', ' ');  // a diagnostic is one line
            throw Error(Diagnostic{{file.string()}, std::string(step) + ": " + reason, {}, {}});
        }
    }

    /// `display` and `view` with their defaults filled in, known to exist. Throws Error.
    struct Target {
        std::string display, view;
    };
    [[nodiscard]] Target target(std::string_view display, std::string_view view) const;
    /// The name of a space, alias, role or "data" as the configuration has it; empty for data without such a role.
    /// Throws Error.
    [[nodiscard]] std::string space(std::string_view name) const;
    [[nodiscard]] OCIO::ConstProcessorRcPtr display_processor(const Target& target) const;
    [[nodiscard]] OCIO::ConstCPUProcessorRcPtr processor(const std::string& from, const std::string& to) const;
};

}  // namespace tyndall
