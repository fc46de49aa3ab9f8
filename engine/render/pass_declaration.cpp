#include <algorithm>
#include <array>

#include "render/frame_graph.h"

namespace tyndall {
namespace {

constexpr std::string_view kPrevious = "@previous";

}  // namespace

std::string_view name_of(Stage stage) {
    constexpr std::array<std::string_view, 11> kNames{"shadow",      "light_space", "geometry", "lighting",
                                                      "diffusion",   "compose",     "sky",      "media",
                                                      "transparent", "post",        "display"};
    return kNames.at(static_cast<size_t>(stage));
}

PassDeclaration& PassDeclaration::stage(Stage stage) {
    stage_ = stage;
    return *this;
}

PassDeclaration& PassDeclaration::reads(std::string target, std::string doc, bool optional) {
    const bool previous = target.ends_with(kPrevious);
    if (previous) target.resize(target.size() - kPrevious.size());
    // Seam providers may ask for what the pass, or another provider, has asked for already.
    for (Access& known : accesses_) {
        if (known.kind != Access::Kind::read || known.target != target || known.previous != previous) continue;
        known.optional = known.optional && optional;
        return *this;
    }
    accesses_.push_back({Access::Kind::read, std::move(target), std::move(doc), optional, previous, {}});
    return *this;
}

PassDeclaration& PassDeclaration::writes(std::string target, const TargetDesc& desc, std::string doc) {
    accesses_.push_back({Access::Kind::write, std::move(target), std::move(doc), false, false, desc});
    return *this;
}

PassDeclaration& PassDeclaration::updates(std::string target, std::string doc) {
    accesses_.push_back({Access::Kind::update, std::move(target), std::move(doc), false, false, {}});
    return *this;
}

PassDeclaration& PassDeclaration::after(std::string pass) {
    after_.push_back(std::move(pass));
    return *this;
}

PassDeclaration& PassDeclaration::keep() {
    keep_ = true;
    return *this;
}

}  // namespace tyndall
