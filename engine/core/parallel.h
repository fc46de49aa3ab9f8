#pragma once
/// Loops over all cores.

#include <cstddef>
#include <memory>

#include "core/function_ref.h"

namespace tyndall {

/// Calls `body(first, last)` for blocks that together cover [begin, end) once, from several threads, and returns when
/// all are done. A block has at most `grain` indices (0 counts as 1), and the blocks depend on the arguments alone, not
/// on the number of threads: what is summed per block and then in order is the same on every machine. An exception of
/// `body` is rethrown here, after which blocks that had not begun are left out. Loops may nest.
void parallel_for(size_t begin, size_t end, size_t grain, FunctionRef<void(size_t first, size_t last)> body);

/// While it lives, loops use at most so many threads.
class ThreadLimit {
 public:
    explicit ThreadLimit(size_t threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
    struct Implementation;
    std::unique_ptr<Implementation> self_;
};

}  // namespace tyndall
