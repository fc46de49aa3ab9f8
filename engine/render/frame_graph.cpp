#include "render/frame_graph.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "core/error.h"
#include "render/graph_context.h"
#include "render/graph_plan.h"
#include "render/graph_textures.h"

namespace tyndall {
namespace {

/// What every pass may rely on, whatever ran before it.
void reset_state() {
    constexpr GLenum kOff[] = {GL_BLEND,        GL_DEPTH_TEST,          GL_CULL_FACE,  GL_SCISSOR_TEST,
                               GL_STENCIL_TEST, GL_POLYGON_OFFSET_FILL, GL_DEPTH_CLAMP};
    for (const GLenum state : kOff) glDisable(state);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_GREATER);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ZERO);
    glCullFace(GL_BACK);
    glFrontFace(GL_CCW);
}

class DebugGroup {
 public:
    explicit DebugGroup(std::string_view name) {
        glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, static_cast<GLsizei>(name.size()), name.data());
    }
    ~DebugGroup() { glPopDebugGroup(); }
    DebugGroup(const DebugGroup&) = delete;
    DebugGroup& operator=(const DebugGroup&) = delete;
};

}  // namespace

struct FrameGraph::Implementation {
    struct Node {
        Pass* pass = nullptr;
        GraphPassContext context;
        gpu::Timer timer;
    };
    /// Everything that a successful build replaces at once.
    struct Built {
        std::vector<Pass*> passes;
        std::vector<DeclaredPass> declared;
        GraphPlan plan;
        GraphTextures textures;
        std::vector<Node> nodes;
        glm::ivec2 size{0};
        bool valid = false;
    };

    std::vector<Pass*> passes;
    std::vector<std::string> retained;
    Built built;
    glm::ivec2 attempted{0};
    bool dirty = true;
    bool timing = false;

    void build(glm::ivec2 size);
    [[nodiscard]] const PlannedTarget* find(std::string_view name) const;
    [[nodiscard]] size_t index(const PlannedTarget& target) const {
        return static_cast<size_t>(&target - built.plan.targets.data());
    }
};

void FrameGraph::Implementation::build(glm::ivec2 size) {
    Built next;
    next.passes = passes;
    next.size = size;
    next.valid = true;
    for (Pass* pass : passes) {
        next.declared.push_back({std::string(pass->name()), {}});
        pass->declare(next.declared.back().declaration);
    }
    next.plan = plan_graph(next.declared, retained);
    std::unordered_map<std::string_view, size_t> targets;
    for (size_t i = 0; i < next.plan.targets.size(); ++i) targets.emplace(next.plan.targets[i].name, i);
    for (const size_t index : next.plan.order)
        next.nodes.push_back({passes[index], GraphPassContext(next.declared[index], next.plan, targets), {}});
    next.textures = GraphTextures(next.plan, size, built.textures);
    built = std::move(next);
    dirty = false;
}

const PlannedTarget* FrameGraph::Implementation::find(std::string_view name) const {
    const auto found = std::ranges::find(built.plan.targets, name, &PlannedTarget::name);
    return found == built.plan.targets.end() ? nullptr : &*found;
}

FrameGraph::FrameGraph() : self_(std::make_unique<Implementation>()) {}
FrameGraph::~FrameGraph() = default;

void FrameGraph::set_passes(std::vector<Pass*> passes) {
    const bool lost = std::ranges::any_of(self_->built.passes,
                                          [&](Pass* old) { return std::ranges::find(passes, old) == passes.end(); });
    if (lost) {  // nothing of a pass that may be gone is kept, its functions neither; textures stay for the next build
        Implementation::Built rest;
        rest.textures = std::move(self_->built.textures);
        rest.textures.forget_owned();
        self_->built = std::move(rest);
    }
    self_->passes = std::move(passes);
    self_->dirty = true;
}

void FrameGraph::invalidate() {
    self_->dirty = true;
}

void FrameGraph::build(glm::ivec2 size) {
    self_->build(glm::max(size, glm::ivec2(1)));
}

void FrameGraph::execute(Frame& frame, glm::ivec2 size, bool camera_cut) {
    Implementation& self = *self_;
    size = glm::max(size, glm::ivec2(1));
    if (self.dirty || !self.built.valid || size != self.attempted) {
        // Once reported, a failed build is not tried each frame: the last good plan runs until something changes.
        self.dirty = false;
        self.attempted = size;
        self.build(size);
    }
    self.built.textures.next_frame(camera_cut);
    for (Implementation::Node& node : self.built.nodes) {
        const DebugGroup group(node.pass->name());
        if (self.timing) node.timer.begin();
        reset_state();
        node.context.begin(frame, self.built.textures, self.built.size);
        node.pass->execute(node.context);
        if (self.timing) node.timer.end();
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

std::vector<std::string> FrameGraph::order() const {
    std::vector<std::string> names;
    for (const size_t index : self_->built.plan.order) names.push_back(self_->built.declared[index].name);
    return names;
}

std::vector<std::string> FrameGraph::targets() const {
    std::vector<std::string> names;
    for (const PlannedTarget& target : self_->built.plan.targets) names.push_back(target.name);
    return names;
}

const gpu::Texture* FrameGraph::target(std::string_view name) const {
    const PlannedTarget* target = self_->find(name);
    if (target == nullptr || !self_->built.textures.survives(self_->index(*target))) return nullptr;
    return self_->built.textures.current(self_->index(*target));
}

void FrameGraph::retain(std::vector<std::string> targets) {
    if (targets == self_->retained) return;
    self_->retained = std::move(targets);
    self_->dirty = true;
}

void FrameGraph::set_timing(bool on) {
    self_->timing = on;
}

std::vector<PassTime> FrameGraph::times() {
    std::vector<PassTime> times;
    for (Implementation::Node& node : self_->built.nodes) {
        const double milliseconds = node.timer.milliseconds();
        if (self_->timing && milliseconds >= 0.0) times.push_back({std::string(node.pass->name()), milliseconds});
    }
    return times;
}

size_t FrameGraph::memory() const {
    return self_->built.textures.memory();
}

std::string FrameGraph::dot() const {
    const Implementation::Built& built = self_->built;
    return graph_text(built.declared, built.plan, built.textures.numbers(), built.size);
}

}  // namespace tyndall
