#pragma once
/// Gauss-Legendre quadrature.

#include <glm/vec2.hpp>
#include <vector>

namespace tyndall::participating_media {

/// Nodes in (-1, 1) and weights: exact for polynomials up to degree 2 count - 1.
[[nodiscard]] std::vector<glm::vec2> gauss_legendre(int count);

}  // namespace tyndall::participating_media
