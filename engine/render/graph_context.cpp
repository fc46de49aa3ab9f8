#include "render/graph_context.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"

namespace tyndall {
namespace {

using Kind = PassDeclaration::Access::Kind;

bool same(const gpu::Framebuffer::Attachment& a, const gpu::Framebuffer::Attachment& b) {
    return a.texture == b.texture && a.mip == b.mip && a.layer == b.layer;
}

}  // namespace

GraphPassContext::GraphPassContext(const DeclaredPass& pass, const GraphPlan& plan,
                                   const std::unordered_map<std::string_view, size_t>& targets)
    : pass_(pass.name) {
    for (const PassDeclaration::Access& access : pass.declaration.accesses_) {
        const auto found = targets.find(access.target);
        Binding binding{
            access.target + (access.previous ? "@previous" : ""), kAbsent, access.kind, access.previous, {}};
        if (found != targets.end()) binding.target = found->second;
        if (access.kind == Kind::write && !access.desc.own) binding.clear = plan.targets[found->second].desc.clear;
        bindings_.push_back(std::move(binding));
    }
    // A pass that updates a target may also have said that it reads it: what may be drawn to is found first.
    std::stable_partition(bindings_.begin(), bindings_.end(),
                          [](const Binding& binding) { return binding.kind != Kind::read; });
}

void GraphPassContext::begin(Frame& frame, const GraphTextures& textures, glm::ivec2 size) {
    frame_ = &frame;
    textures_ = &textures;
    size_ = size;
    for (const Binding& binding : bindings_)
        if (binding.clear) clear(binding);
}

const GraphPassContext::Binding* GraphPassContext::find(std::string_view name) const {
    const auto found = std::ranges::find(bindings_, name, &Binding::name);
    return found == bindings_.end() ? nullptr : &*found;
}

const gpu::Texture* GraphPassContext::texture_of(const Binding& binding) const {
    if (binding.target == kAbsent) return nullptr;
    return binding.previous ? textures_->previous(binding.target) : textures_->current(binding.target);
}

const gpu::Texture& GraphPassContext::texture(std::string_view target) const {
    const Binding* binding = find(target);
    if (binding == nullptr) throw Error(fmt::format("pass '{}' uses '{}', which it did not declare", pass_, target));
    const gpu::Texture* texture = texture_of(*binding);
    if (texture == nullptr) throw Error(fmt::format("pass '{}' uses '{}', which has no content yet", pass_, target));
    return *texture;
}

const gpu::Texture* GraphPassContext::find_texture(std::string_view target) const {
    const Binding* binding = find(target);
    return binding == nullptr ? nullptr : texture_of(*binding);
}

void GraphPassContext::add(Attachments& attachments, const Binding& binding, int layer, int mip) const {
    const gpu::Texture* texture = texture_of(binding);
    const gpu::Framebuffer::Attachment attachment{texture, mip, texture->desc().shape == gpu::Shape::flat ? -1 : layer};
    if (gpu::is_depth(texture->desc().format))
        attachments.depth = attachment;
    else if (attachments.count < kMaxColours)
        attachments.colours[attachments.count++] = attachment;
    else
        throw Error(fmt::format("pass '{}' draws to more than {} colour targets", pass_, kMaxColours));
}

const gpu::Framebuffer& GraphPassContext::framebuffer(const Attachments& wanted) {
    for (const Cached& known : framebuffers_) {
        const Attachments& have = known.attachments;
        if (have.count == wanted.count && same(have.depth, wanted.depth) &&
            std::equal(have.colours.begin(), have.colours.end(), wanted.colours.begin(), same))
            return known.framebuffer;
    }
    if (wanted.count == 0 && wanted.depth.texture == nullptr)
        throw Error(fmt::format("pass '{}' binds targets but has none that it writes or updates", pass_));
    const std::span colours(wanted.colours.data(), wanted.count);
    framebuffers_.push_back({wanted, gpu::Framebuffer(colours, wanted.depth, pass_)});
    return framebuffers_.back().framebuffer;
}

void GraphPassContext::bind_targets() {
    Attachments attachments;
    for (const Binding& binding : bindings_)
        if (const gpu::Texture* texture = binding.kind == Kind::read ? nullptr : texture_of(binding);
            texture != nullptr && texture->desc().shape == gpu::Shape::flat)
            add(attachments, binding, -1, 0);
    framebuffer(attachments).bind();
}

void GraphPassContext::bind_targets(std::span<const std::string_view> targets, int layer, int mip) {
    Attachments attachments;
    for (const std::string_view target : targets) {
        const Binding* binding = find(target);
        const gpu::Texture* texture = binding == nullptr || binding->previous ? nullptr : texture_of(*binding);
        if (texture == nullptr || (binding->kind == Kind::read && !gpu::is_depth(texture->desc().format)))
            throw Error(fmt::format("pass '{}' binds '{}', which it neither writes nor updates", pass_, target));
        add(attachments, *binding, layer, mip);
    }
    framebuffer(attachments).bind();
}

void GraphPassContext::clear(const Binding& binding) {
    const gpu::Texture& texture = *texture_of(binding);
    for (int mip = 0; mip < texture.desc().mips; ++mip) {
        Attachments attachments;
        add(attachments, binding, -1, mip);
        const GLuint target = framebuffer(attachments).name();
        const glm::uvec4 integers(glm::max(*binding.clear, 0.0f));
        if (texture.desc().format == gpu::Format::r32ui)
            glClearNamedFramebufferuiv(target, GL_COLOR, 0, &integers.x);
        else
            glClearNamedFramebufferfv(target, attachments.count > 0 ? GL_COLOR : GL_DEPTH, 0, &binding.clear->x);
    }
}

}  // namespace tyndall
