#include "physics/probe.h"

#include <cmath>

namespace tyndall::physics {

Sh9 project_equirect(std::span<const glm::vec3> pixels, int width, int height) {
    glm::dvec3 sums[9] = {};
    for (int y = 0; y < height; ++y) {
        // the exact solid angle of a pixel of this row: the weights add up to 4 pi at any size
        const double top = std::cos(double(kPi) * y / height);
        const double bottom = std::cos(double(kPi) * (y + 1) / height);
        const double solid_angle = (top - bottom) * 2.0 * double(kPi) / width;
        for (int x = 0; x < width; ++x) {
            const vec2 uv((float(x) + 0.5f) / float(width), (float(y) + 0.5f) / float(height));
            const glm::dvec3 light = glm::dvec3(pixels[size_t(y) * size_t(width) + size_t(x)]) * solid_angle;
            float y0, y2_last;
            vec3 y1;
            vec4 y2;
            sh9_basis(equirect_to_direction(uv), y0, y1, y2, y2_last);
            const float basis[9] = {y0, y1.x, y1.y, y1.z, y2.x, y2.y, y2.z, y2.w, y2_last};
            for (int i = 0; i < 9; ++i) sums[i] += light * double(basis[i]);
        }
    }
    Sh9 sh;
    for (int i = 0; i < 9; ++i) sh.c[i] = vec4(vec3(sums[i]), 0.0f);
    return sh;
}

}  // namespace tyndall::physics
