#include "core/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

#include <algorithm>

namespace tyndall {

void parallel_for(size_t begin, size_t end, size_t grain, FunctionRef<void(size_t, size_t)> body) {
    if (begin >= end) return;
    grain = std::max<size_t>(grain, 1);
    if (end - begin <= grain) return body(begin, end);
    // The simple partitioner halves down to the grain whatever the threads do: the blocks are always the same.
    tbb::parallel_for(
        tbb::blocked_range<size_t>(begin, end, grain),
        [&](const tbb::blocked_range<size_t>& block) { body(block.begin(), block.end()); }, tbb::simple_partitioner());
}

struct ThreadLimit::Implementation {
    tbb::global_control control;
};

ThreadLimit::ThreadLimit(size_t threads)
    : self_(new Implementation{{tbb::global_control::max_allowed_parallelism, std::max<size_t>(threads, 1)}}) {}
ThreadLimit::~ThreadLimit() = default;

}  // namespace tyndall
