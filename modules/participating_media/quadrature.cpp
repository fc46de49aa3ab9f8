#include "quadrature.h"

#include <cmath>
#include <numbers>

namespace tyndall::participating_media {

std::vector<glm::vec2> gauss_legendre(int count) {
    std::vector<glm::vec2> nodes;
    for (int i = 0; i < count; ++i) {
        double x = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5)), slope = 1.0;
        for (int iteration = 0; iteration < 8; ++iteration) {  // Newton's; the start is within 1e-3 of the root
            double before = 1.0, here = x;
            for (int j = 1; j < count; ++j) {
                const double after = ((2.0 * j + 1.0) * x * here - j * before) / (j + 1.0);
                before = here;
                here = after;
            }
            slope = count * (before - x * here) / (1.0 - x * x);
            x -= here / slope;
        }
        nodes.emplace_back(static_cast<float>(x), static_cast<float>(2.0 / ((1.0 - x * x) * slope * slope)));
    }
    return nodes;
}

}  // namespace tyndall::participating_media
