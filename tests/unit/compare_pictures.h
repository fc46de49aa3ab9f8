#pragma once
/// Pictures that tests of comparisons share.

#include <cmath>
#include <cstdint>

#include "image/image.h"

namespace tyndall {

inline Image filled(int width, int height, float r, float g, float b) {
    Image image(width, height, 3, Image::Type::f32);
    const float colour[] = {r, g, b};
    for (size_t i = 0; i < image.value_count(); ++i) image.floats()[i] = colour[i % 3];
    return image;
}

inline Image waves(int width, int height) {
    Image image(width, height, 3, Image::Type::f32);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c)
                image.at(x, y, c) =
                    0.5f + 0.4f * std::sin(0.13f * static_cast<float>(x * (c + 1)) + 0.07f * static_cast<float>(y));
    return image;
}

/// Noise of 0..1 that any language computes alike.
inline double hashed(int x, int y, int seed) {
    const int64_t n = ((int64_t{x} * 73856093) ^ (int64_t{y} * 19349663) ^ (int64_t{seed} * 83492791)) % 1000003;
    return static_cast<double>(n * n % 1000003) / 1000003.0;
}

}  // namespace tyndall
