#include "media_programs.h"

#include <fmt/format.h>

#include "render/frame.h"
#include "render/seams.h"

namespace tyndall::participating_media {

std::vector<std::string> phase_defines(std::optional<PhaseKind> phase) {
    if (!phase) return {};
    return {fmt::format("PHASE_KIND {}", static_cast<int>(*phase))};
}

void bind_light_source(const gpu::Program& program, PassContext& context, const MediaBuffer& media, int light_steps) {
    context.frame().seams.bind(Seam::light_transmittance, program, context);
    media.bind(program, light_steps);
    program.texture("phase_tables", media.phase_tables(), {.filter = gpu::Filter::linear});
}

LightPrograms& MediaPrograms::of(std::optional<PhaseKind> phase, std::array<int, 2> values) {
    const Key key{phase, values};
    auto known = programs_.find(key);
    if (known == programs_.end()) {
        gpu::ProgramDesc desc = base_;
        for (size_t i = 0; i < numbers_.size(); ++i)
            desc.defines.push_back(fmt::format("{} {}", numbers_[i], values.at(i)));
        for (std::string& define : phase_defines(phase)) desc.defines.push_back(std::move(define));
        known = programs_.try_emplace(key, std::move(desc)).first;
    }
    if (last_ != &known->second) known->second.begin();  // another variant's program is in use
    last_ = &known->second;
    return *last_;
}

}  // namespace tyndall::participating_media
