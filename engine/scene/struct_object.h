#pragma once
/// One value of a type that is known by its description only.

#include <algorithm>
#include <memory>
#include <new>
#include <utility>

#include "ecs/description.h"

namespace tyndall {

/// Owns a default-constructed or copied object of a described type and destroys it. The description need not outlive
/// it; the code behind it must.
class StructObject {
 public:
    explicit StructObject(const StructType& type) : StructObject(type, Memory{}) { type.construct(memory_); }
    StructObject(const StructType& type, const void* from) : StructObject(type, Memory{}) {
        type.copy_construct(memory_, from);
    }
    ~StructObject() {
        if (!memory_) return;
        destroy_(memory_);
        ::operator delete(memory_, alignment_);
    }
    StructObject(StructObject&& other) noexcept
        : destroy_(other.destroy_), alignment_(other.alignment_), memory_(std::exchange(other.memory_, nullptr)) {}
    StructObject& operator=(StructObject&& other) noexcept {
        std::swap(destroy_, other.destroy_);
        std::swap(alignment_, other.alignment_);
        std::swap(memory_, other.memory_);
        return *this;
    }
    StructObject(const StructObject&) = delete;
    StructObject& operator=(const StructObject&) = delete;

    [[nodiscard]] void* get() { return memory_; }
    [[nodiscard]] const void* get() const { return memory_; }

 private:
    struct Memory {};
    StructObject(const StructType& type, Memory)
        : destroy_(type.destroy),
          alignment_(std::align_val_t{type.alignment}),
          memory_(::operator new(std::max<size_t>(type.size, 1), alignment_)) {}
    void (*destroy_)(void*);
    std::align_val_t alignment_;
    void* memory_;
};

}  // namespace tyndall
