#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "gpu/accounting.h"
#include "gpu/gpu.h"

namespace tyndall::gpu {
namespace {

glm::ivec2 size_of(const Framebuffer::Attachment& attachment) {
    const TextureDesc& desc = attachment.texture->desc();
    return {std::max(1, desc.width >> attachment.mip), std::max(1, desc.height >> attachment.mip)};
}

void attach(GLuint framebuffer, GLenum point, const Framebuffer::Attachment& attachment) {
    const GLuint texture = attachment.texture->name();
    if (attachment.layer < 0 || attachment.texture->desc().shape == Shape::flat)
        glNamedFramebufferTexture(framebuffer, point, texture, attachment.mip);
    else
        glNamedFramebufferTextureLayer(framebuffer, point, texture, attachment.mip, attachment.layer);
}

std::string_view reason(GLenum status) {
    switch (status) {
        case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
            return "an attachment cannot be drawn to";
        case GL_FRAMEBUFFER_INCOMPLETE_LAYER_TARGETS:
            return "some attachments are layered and some are not";
        case GL_FRAMEBUFFER_UNSUPPORTED:
            return "the driver does not support this combination of formats";
        default:
            return "the driver refuses it";
    }
}

}  // namespace

Framebuffer::Framebuffer(std::span<const Attachment> colours, const Attachment& depth, std::string_view label) {
    glCreateFramebuffers(1, &name_);
    tally().framebuffers += 1;
    set_label(GL_FRAMEBUFFER, name_, label);
    bool one_size = true;
    const auto add = [&](GLenum point, const Attachment& attachment) {
        attach(name_, point, attachment);
        one_size = one_size && (size_.x == 0 || size_ == size_of(attachment));
        size_ = size_of(attachment);
    };
    std::vector<GLenum> draw_buffers;
    for (size_t i = 0; i < colours.size(); ++i) {
        const GLenum point = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
        if (colours[i].texture) add(point, colours[i]);
        draw_buffers.push_back(colours[i].texture ? point : GL_NONE);
    }
    if (depth.texture) add(GL_DEPTH_ATTACHMENT, depth);
    if (size_.x == 0) {
        *this = Framebuffer();  // the destructor does not run for what threw in its constructor
        throw Error(fmt::format("framebuffer '{}' has no attachment", label));
    }
    glNamedFramebufferDrawBuffers(name_, static_cast<GLsizei>(draw_buffers.size()), draw_buffers.data());
    const GLenum status = glCheckNamedFramebufferStatus(name_, GL_DRAW_FRAMEBUFFER);
    if (status == GL_FRAMEBUFFER_COMPLETE && one_size) return;
    *this = Framebuffer();
    throw Error(fmt::format("framebuffer '{}' is incomplete: {}", label,
                            one_size ? reason(status) : "its attachments differ in size"));
}

Framebuffer::~Framebuffer() {
    if (name_ == 0) return;
    glDeleteFramebuffers(1, &name_);
    tally().framebuffers -= 1;
}

void Framebuffer::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, name_);
    glViewport(0, 0, size_.x, size_.y);
}

void Framebuffer::clear_colour(int index, glm::vec4 value) const {
    glClearNamedFramebufferfv(name_, GL_COLOR, index, &value.x);
}

void Framebuffer::clear_depth(float value) const {
    glClearNamedFramebufferfv(name_, GL_DEPTH, 0, &value);
}

}  // namespace tyndall::gpu
