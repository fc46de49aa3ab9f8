#include <epoxy/gl.h>

#include <cassert>

#include "gpu/accounting.h"
#include "gpu/gpu.h"

namespace tyndall::gpu {

Alive& tally() {
    static Alive instance;
    return instance;
}

Alive alive() {
    return tally();
}

void set_label(unsigned int kind, unsigned int name, std::string_view label) {
    if (!label.empty()) glObjectLabel(kind, name, static_cast<GLsizei>(label.size()), label.data());
}

Buffer::Buffer(size_t bytes, const void* data, std::string_view label) : size_(bytes) {
    glCreateBuffers(1, &name_);
    set_label(GL_BUFFER, name_, label);
    // GL refuses empty storage; an empty list of lights is still a buffer.
    const auto storage = static_cast<GLsizeiptr>(bytes > 0 ? bytes : 16);
    glNamedBufferStorage(name_, storage, bytes > 0 ? data : nullptr, GL_DYNAMIC_STORAGE_BIT);
    tally().buffers += 1;
    tally().buffer_bytes += size_;
}

Buffer::~Buffer() {
    if (name_ == 0) return;
    glDeleteBuffers(1, &name_);
    tally().buffers -= 1;
    tally().buffer_bytes -= size_;
}

void Buffer::update(size_t offset, size_t bytes, const void* data) {
    assert(offset + bytes <= size_);
    if (bytes > 0) glNamedBufferSubData(name_, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), data);
}

void Buffer::read(size_t offset, size_t bytes, void* data) const {
    assert(offset + bytes <= size_);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    if (bytes > 0) glGetNamedBufferSubData(name_, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), data);
}

}  // namespace tyndall::gpu
