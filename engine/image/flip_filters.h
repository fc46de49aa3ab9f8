#pragma once
/// FLIP's filters: what the eye resolves, and what catches it. Names and numbers are the paper's (see flip.cpp).

#include <initializer_list>
#include <vector>

namespace tyndall::flip {

/// One channel of a picture, row by row.
using Plane = std::vector<float>;

/// A picture's width and height, for filters that repeat the border.
struct Extent {
    int width = 0;
    int height = 0;
};

/// One Gaussian of a contrast sensitivity function: a sqrt(pi/b) exp(-pi^2 d^2 / b), d in degrees.
struct Sensitivity {
    float a, b;
};

/// Filters one channel by a sum of Gaussians whose weights, over the square kernel, sum to 1.
[[nodiscard]] Plane contrast_filtered(const Plane& in, Extent extent, std::initializer_list<Sensitivity> terms,
                                      float pixels_per_degree);

/// Magnitudes of the first and second derivative of the lightness.
struct Features {
    Plane edges, points;
};
/// `lightness` is 0..1.
[[nodiscard]] Features features_of(const Plane& lightness, Extent extent, float pixels_per_degree);

}  // namespace tyndall::flip
