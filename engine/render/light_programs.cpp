#include "render/light_programs.h"

#include <fmt/format.h>

#include "render/light_buffer.h"

namespace tyndall {

LightPrograms::LightPrograms(gpu::ProgramDesc base) : base_(std::move(base)) {}

const gpu::ProgramDesc& LightPrograms::variant(const Frame& frame, size_t light) {
    const GpuLight& known = frame.lights.lights()[light];
    const auto kind = static_cast<size_t>(known.direction_kind.w);
    const size_t gobo = known.gobo.x >= 0.0f ? 1 : 0;
    const size_t highlight = known.shadow.y == 0.0f ? 1 : 0;
    const auto views = static_cast<size_t>(known.shadow.x);
    gpu::ProgramDesc& desc = variants_.at(((kind * 2 + gobo) * 2 + highlight) * kViews + views);
    if (desc.fragment.empty() && desc.compute.empty()) {
        desc = base_;
        for (std::string define :
             {std::string("ONE_LIGHT"), fmt::format("LIGHT_KIND {}", kind), fmt::format("LIGHT_GOBO {}", gobo),
              fmt::format("LIGHT_HIGHLIGHT {}", highlight), fmt::format("SHADOW_VIEWS {}", views)})
            desc.defines.push_back(std::move(define));
    }
    return desc;
}

}  // namespace tyndall
