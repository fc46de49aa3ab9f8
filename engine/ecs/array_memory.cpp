#include "ecs/array_memory.h"

#include <sys/mman.h>

#include <algorithm>
#include <new>

namespace tyndall::detail {

void* allocate_array(size_t bytes, size_t alignment) {
    constexpr size_t kHugePage = size_t{1} << 21;
    const bool large = bytes >= 2 * kHugePage;
    alignment = std::max(alignment, large ? kHugePage : alignof(std::max_align_t));
    bytes = (bytes + alignment - 1) / alignment * alignment;
    void* array = std::aligned_alloc(alignment, bytes);
    if (array == nullptr) throw std::bad_alloc();
    if (large) (void)madvise(array, bytes, MADV_HUGEPAGE);  // a wish: where it is refused, small pages serve as well
    return array;
}

}  // namespace tyndall::detail
