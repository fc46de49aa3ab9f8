#pragma once
/// Memory for large arrays.

#include <cstddef>
#include <cstdlib>

namespace tyndall::detail {

/// Memory for an array, given back with std::free. Large arrays ask for huge pages: with a million entities the page
/// faults of first use would otherwise cost several times what filling the arrays does, and random access would miss
/// the TLB. Throws std::bad_alloc.
[[nodiscard]] void* allocate_array(size_t bytes, size_t alignment);

/// A std::vector's allocator from `allocate_array`.
template <class T>
struct ArrayAllocator {
    using value_type = T;
    ArrayAllocator() = default;
    template <class U>
    ArrayAllocator(const ArrayAllocator<U>&) {}
    [[nodiscard]] T* allocate(size_t count) { return static_cast<T*>(allocate_array(count * sizeof(T), alignof(T))); }
    void deallocate(T* array, size_t) { std::free(array); }
    bool operator==(const ArrayAllocator&) const { return true; }
};

}  // namespace tyndall::detail
