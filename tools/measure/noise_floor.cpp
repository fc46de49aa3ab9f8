#include "measure/noise_floor.h"

#include "core/error.h"

namespace tyndall::measure {

double noise_floor(const NoisyPicture& reference) {
    if (reference.variance.empty()) return -1;
    const auto values = reference.radiance.floats(), variances = reference.variance.floats();
    if (values.size() != variances.size()) throw Error("a reference's variance is of another size than its picture");
    double mean = 0;
    for (const float value : values) mean += static_cast<double>(value);
    mean /= static_cast<double>(values.size());
    double sum = 0;
    for (size_t i = 0; i < values.size(); ++i) {
        const auto value = static_cast<double>(values[i]);
        const double scale = value * value + 0.01 * mean * mean;
        if (scale > 0) sum += static_cast<double>(variances[i]) / scale;
    }
    return sum / static_cast<double>(values.size());
}

}  // namespace tyndall::measure
