#pragma once
/// The worst 8x8 blocks of an error map: a mean hides small, strong errors; a maximum is noise.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace tyndall {

struct Block {
    double mean = 0;
    int x = 0;  ///< left pixel
    int y = 0;  ///< top pixel
};

/// Means of a one-channel map over the blocks of a grid of 8 pixels, whole ones only (a map smaller than a block is one
/// block). With a mask (a byte for each pixel, 0 = left out; empty = all count) a block's mean is over what counts, and
/// a block of which less than half counts is left out.
inline std::vector<Block> block_means(std::span<const float> map, int width, int height,
                                      std::span<const std::uint8_t> mask = {}) {
    const int block_width = std::min(8, width);
    const int block_height = std::min(8, height);
    std::vector<Block> blocks;
    for (int y = 0; y + block_height <= height; y += block_height)
        for (int x = 0; x + block_width <= width; x += block_width) {
            double sum = 0;
            int count = 0;
            for (int row = y; row < y + block_height; ++row)
                for (int column = x; column < x + block_width; ++column) {
                    const auto i = static_cast<size_t>(row) * static_cast<size_t>(width) + static_cast<size_t>(column);
                    if (!mask.empty() && mask[i] == 0) continue;
                    sum += static_cast<double>(map[i]);
                    ++count;
                }
            if (2 * count >= block_width * block_height) blocks.push_back({sum / count, x, y});
        }
    return blocks;
}

/// The blocks with the largest means above 0, worst first, at most `count`; equals in reading order.
inline std::vector<Block> worst_blocks(std::span<const float> map, int width, int height, size_t count,
                                       std::span<const std::uint8_t> mask = {}) {
    std::vector<Block> blocks = block_means(map, width, height, mask);
    std::erase_if(blocks, [](const Block& block) { return !(block.mean > 0); });
    std::ranges::stable_sort(blocks, [](const Block& a, const Block& b) { return a.mean > b.mean; });
    if (blocks.size() > count) blocks.resize(count);
    return blocks;
}

/// The block with the largest mean; 0 at the top left when the map is zero.
inline Block worst_block(std::span<const float> map, int width, int height, std::span<const std::uint8_t> mask = {}) {
    const std::vector<Block> worst = worst_blocks(map, width, height, 1, mask);
    return worst.empty() ? Block{} : worst.front();
}

}  // namespace tyndall
