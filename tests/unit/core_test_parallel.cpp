// Loops over all cores, and references to callables.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <vector>

#include "core/parallel.h"

namespace tyndall {
namespace {

using Blocks = std::set<std::pair<size_t, size_t>>;

Blocks blocks_of(size_t begin, size_t end, size_t grain) {
    Blocks blocks;
    std::mutex mutex;
    parallel_for(begin, end, grain, [&](size_t first, size_t last) {
        const std::lock_guard lock(mutex);
        blocks.emplace(first, last);
    });
    return blocks;
}

TEST(FunctionRef, CallsWhatItRefersTo) {
    int calls = 0;
    const auto count = [&](int by) { return calls += by; };
    const FunctionRef<int(int)> reference = count;
    const FunctionRef<int(int)> copy = reference;
    EXPECT_EQ(reference(2), 2);
    EXPECT_EQ(copy(3), 5);
    auto moved_through = [](std::unique_ptr<int> value) { return value; };
    EXPECT_EQ(*FunctionRef<std::unique_ptr<int>(std::unique_ptr<int>)>(moved_through)(std::make_unique<int>(7)), 7);
    static_assert(!std::is_constructible_v<FunctionRef<void(int)>, int>);
}

TEST(ParallelFor, CoversEachIndexOnceInBlocksNoLargerThanTheGrain) {
    for (const size_t grain : {0, 1, 7, 64, 1000, 5000}) {
        std::vector<std::atomic<int>> visits(1003);
        parallel_for(3, 1003, grain, [&](size_t first, size_t last) {
            EXPECT_LE(last - first, std::max<size_t>(grain, 1));
            for (size_t i = first; i < last; ++i) ++visits[i];
        });
        for (size_t i = 0; i < visits.size(); ++i) ASSERT_EQ(visits[i], i < 3 ? 0 : 1) << i;
    }
    parallel_for(5, 5, 1, [](size_t, size_t) { FAIL(); });
    parallel_for(6, 5, 1, [](size_t, size_t) { FAIL(); });
}

TEST(ParallelFor, BlocksDependOnTheArgumentsAlone) {
    const Blocks once = blocks_of(0, 1000, 32);
    EXPECT_GT(once.size(), 30u);
    for (int run = 0; run < 20; ++run) ASSERT_EQ(blocks_of(0, 1000, 32), once);
}

TEST(ParallelFor, ExceptionsComeOutAndLoopsNest) {
    EXPECT_THROW(parallel_for(0, 100, 1,
                              [](size_t first, size_t) {
                                  if (first == 50) throw std::runtime_error("fifty");
                              }),
                 std::runtime_error);
    std::atomic<size_t> sum = 0;
    parallel_for(0, 20, 1, [&](size_t outer, size_t) {
        parallel_for(0, 20, 1, [&](size_t inner, size_t) { sum += outer * inner; });
    });
    EXPECT_EQ(sum, 190u * 190u);
}

}  // namespace
}  // namespace tyndall
