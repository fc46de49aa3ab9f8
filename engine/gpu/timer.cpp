#include <epoxy/gl.h>

#include <chrono>

#include "gpu/gpu.h"

namespace tyndall::gpu {
namespace {

constexpr size_t kRing = 8;  // measurements in flight: more frames than any driver queues

double now_ms() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Software renderers answer timer queries with the time of submission.
bool queries_lie() {
    return shades_on_processor();
}

}  // namespace

bool shades_on_processor() {
    const auto* text = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    const std::string_view renderer = text ? text : "";
    for (const std::string_view software : {"llvmpipe", "softpipe", "SwiftShader"})
        if (renderer.find(software) != std::string_view::npos) return true;
    return false;
}

Timer::~Timer() {
    if (!queries_.empty()) glDeleteQueries(static_cast<GLsizei>(queries_.size()), queries_.data());
}

Timer& Timer::operator=(Timer&& other) noexcept {
    std::swap(queries_, other.queries_);
    std::swap(begun_, other.begun_);
    std::swap(read_, other.read_);
    std::swap(running_, other.running_);
    std::swap(start_, other.start_);
    std::swap(last_, other.last_);
    return *this;
}

void Timer::begin() {
    if (queries_lie()) {
        glFinish();
        start_ = now_ms();
        return;
    }
    if (queries_.empty()) {
        queries_.resize(2 * kRing);
        glCreateQueries(GL_TIMESTAMP, static_cast<GLsizei>(queries_.size()), queries_.data());
    }
    collect();
    running_ = begun_ - read_ < kRing;
    if (running_) glQueryCounter(queries_[2 * (begun_ % kRing)], GL_TIMESTAMP);
}

void Timer::end() {
    if (queries_.empty()) {
        glFinish();
        last_ = now_ms() - start_;
    } else if (running_) {
        glQueryCounter(queries_[2 * (begun_ % kRing) + 1], GL_TIMESTAMP);
        ++begun_;
        running_ = false;
    }
}

void Timer::collect() {
    while (read_ < begun_) {
        const GLuint first = queries_[2 * (read_ % kRing)];
        const GLuint second = queries_[2 * (read_ % kRing) + 1];
        GLuint ready = GL_FALSE;
        glGetQueryObjectuiv(second, GL_QUERY_RESULT_AVAILABLE, &ready);
        if (ready == GL_FALSE) return;
        GLuint64 from = 0;
        GLuint64 to = 0;
        glGetQueryObjectui64v(first, GL_QUERY_RESULT, &from);
        glGetQueryObjectui64v(second, GL_QUERY_RESULT, &to);
        last_ = static_cast<double>(to - from) * 1e-6;
        ++read_;
    }
}

double Timer::milliseconds() {
    collect();
    return last_;
}

std::string_view Timer::method() {
    return queries_lie() ? "glFinish and CPU clock" : "GL timer queries";
}

void finish() {
    glFinish();
}

}  // namespace tyndall::gpu
