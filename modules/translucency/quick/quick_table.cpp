#include "quick/quick_table.h"

#include <algorithm>

namespace tyndall::translucency {

void QuickTable::begin(size_t surfaces) {
    width_ = surfaces + 1;
    rows_.assign(kRows * width_, glm::vec4(0.0f));
    bodies_.clear();
    versions_.clear();
    use_ = {};
}

void QuickTable::add(const SeenSurface& seen, const QuickBody& body, QuickKind kind, const glm::vec4& lobe) {
    const auto column = size_t(seen.number);
    if (column >= width_) return;
    const Bounds& bounds = seen.surface->bounds;
    const bool goes_through = kind == QuickKind::thickness;  // in the place of what goes around
    const float lift = 0.5f * body.wrap.a * body.wrap.a * body.size.radius;
    rows_[column] = {body.wrap.a, lift, float(kind), float(2 * bodies_.size())};
    rows_[width_ + column] = {bounds.centre(), 0.5f * glm::distance(bounds.low, bounds.high)};
    rows_[2 * width_ + column] = goes_through ? lobe : glm::vec4(body.wrap.wide, 0.0f);
    rows_[3 * width_ + column] = goes_through ? glm::vec4(0.0f) : glm::vec4(body.wrap.even, 0.0f);
    bodies_.push_back(&body);
    versions_.push_back(body.version);
    use_.pixels = united(use_.pixels, seen.pixels);
    const char* define = goes_through ? "QUICK_THICKNESS" : "QUICK_WRAP";
    if (std::ranges::find(use_.defines, define) == use_.defines.end()) use_.defines.emplace_back(define);
}

void QuickTable::upload() {
    if (bodies_.empty()) return;
    const auto rgba32f = [](int width, int height, const char* name) {
        return gpu::Texture({.format = gpu::Format::rgba32f, .width = width, .height = height}, name);
    };
    if (rows_ != uploaded_rows_) {
        surfaces_ = rgba32f(int(width_), int(kRows), "translucency.quick.bodies");
        surfaces_.upload(0, 0, rows_.data());
        uploaded_rows_ = rows_;
    }
    if (versions_ != uploaded_versions_) {
        std::vector<glm::vec4> all;
        for (const QuickBody* body : bodies_) all.insert(all.end(), body->patterns.begin(), body->patterns.end());
        patterns_ = rgba32f(QuickBody::kCosines, int(2 * bodies_.size()), "translucency.quick.patterns");
        patterns_.upload(0, 0, all.data());
        uploaded_versions_ = versions_;
    }
}

void QuickTable::bind(const gpu::Program& program) const {
    if (bodies_.empty()) return;
    program.texture("quick_bodies", surfaces_, {.filter = gpu::Filter::nearest});
    program.texture("quick_patterns", patterns_, {.filter = gpu::Filter::nearest});
}

}  // namespace tyndall::translucency
