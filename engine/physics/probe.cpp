#include "physics/probe.h"

#include <algorithm>
#include <cmath>

namespace tyndall::physics {
namespace {

/// The cosine of the angle from the top at which row y begins.
double cos_top(int y, int height) {
    return std::cos(double(kPi) * y / height);
}

/// The exact solid angle of a pixel of row y: those of all pixels add up to 4 pi at any size.
double pixel_solid_angle(int y, int width, int height) {
    return (cos_top(y, height) - cos_top(y + 1, height)) * 2.0 * double(kPi) / width;
}

/// Where a sum reaches a value.
struct Reached {
    size_t index = 0;    ///< the element by which it does
    double share = 0.0;  ///< of that element, [0, 1)
};

/// `sums` rise; `value` is in [0, last).
Reached reach(std::span<const double> sums, double value) {
    const auto index = size_t(std::ranges::upper_bound(sums, value) - sums.begin());
    const double before = index > 0 ? sums[index - 1] : 0.0;
    return {index, (value - before) / (sums[index] - before)};
}

/// The luminance of an image times solid angle, summed along rows and over rows.
class EquirectSums {
 public:
    EquirectSums(std::span<const glm::vec3> pixels, int width, int height) : width_(size_t(width)), height_(height) {
        double total = 0.0;
        for (int y = 0; y < height; ++y) {
            const double solid_angle = pixel_solid_angle(y, width, height);
            double row = 0.0;
            for (size_t x = 0; x < width_; ++x) {
                row += std::max(double(luminance_rec709(pixels[size_t(y) * width_ + x])), 0.0) * solid_angle;
                columns_.push_back(row);
            }
            rows_.push_back(total += row);
        }
    }

    /// The integral of luminance over the sphere.
    [[nodiscard]] double total() const { return rows_.back(); }

    /// The pixel and the direction for a place in the unit square, by luminance times solid angle.
    size_t sample(double u, double v, vec3& direction) const {
        const Reached row = reach(rows_, u * total());
        const std::span<const double> columns(&columns_[row.index * width_], width_);
        const Reached column = reach(columns, v * columns.back());
        const int y = int(row.index);
        const double cosine = glm::mix(cos_top(y, height_), cos_top(y + 1, height_), row.share);
        direction = equirect_to_direction(vec2((double(column.index) + column.share) / double(width_),
                                               std::acos(std::clamp(cosine, -1.0, 1.0)) / double(kPi)));
        return row.index * width_ + column.index;
    }

 private:
    size_t width_;
    int height_;
    std::vector<double> columns_, rows_;
};

}  // namespace

Sh9 project_equirect(std::span<const glm::vec3> pixels, int width, int height) {
    glm::dvec3 sums[9] = {};
    for (int y = 0; y < height; ++y) {
        const double solid_angle = pixel_solid_angle(y, width, height);
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

std::vector<DistantLight> lights_of_equirect(std::span<const glm::vec3> pixels, int width, int height, int count) {
    const EquirectSums sums(pixels, width, height);
    std::vector<DistantLight> lights;
    if (!(sums.total() > 0.0)) return lights;
    std::vector<size_t> taken;  // pixel of each light
    for (int i = 0; i < count; ++i) {
        vec3 direction;
        const size_t pixel = sums.sample((i + 0.5) / count, double(golden_ratio_sequence(uint(i))), direction);
        const vec3 illuminance =
            pixels[pixel] * float(sums.total() / (count * double(luminance_rec709(pixels[pixel]))));
        const auto known = size_t(std::ranges::find(taken, pixel) - taken.begin());
        if (known == taken.size()) {
            taken.push_back(pixel);
            lights.push_back({vec3(0.0f), vec3(0.0f)});
        }
        lights[known].direction += direction;
        lights[known].illuminance += illuminance;
    }
    for (DistantLight& light : lights) light.direction = normalize(light.direction);
    return lights;
}

}  // namespace tyndall::physics
