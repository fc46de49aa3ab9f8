#pragma once
/// The worst 8x8 block of an error map: a mean hides small, strong errors; a maximum is noise.

#include <algorithm>
#include <span>

namespace tyndall {

struct Block {
    double mean = 0;
    int x = 0;  ///< left pixel
    int y = 0;  ///< top pixel
};

/// The block with the largest mean of a one-channel map; blocks lie on a grid of 8 pixels, whole ones only (a map
/// smaller than a block is one block).
inline Block worst_block(std::span<const float> map, int width, int height) {
    const int block_width = std::min(8, width);
    const int block_height = std::min(8, height);
    Block worst;
    for (int y = 0; y + block_height <= height; y += block_height)
        for (int x = 0; x + block_width <= width; x += block_width) {
            double sum = 0;
            for (int row = y; row < y + block_height; ++row)
                for (int column = x; column < x + block_width; ++column)
                    sum += static_cast<double>(map[static_cast<size_t>(row * width + column)]);
            const double mean = sum / (block_width * block_height);
            if (mean > worst.mean) worst = {mean, x, y};
        }
    return worst;
}

}  // namespace tyndall
