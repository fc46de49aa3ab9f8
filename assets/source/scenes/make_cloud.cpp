// Makes assets/scenes/volumes/cloud.vdb: a small cumulus on 128^3 voxels, sparse, half floats. Python has no writer for
// the format.
//
//     g++ -std=c++20 -O2 make_cloud.cpp -o make_cloud -lopenvdb -ltbb -lImath-3_1 && ./make_cloud
//     ../../scenes/volumes/cloud.vdb
#include <openvdb/openvdb.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace {

constexpr int kVoxels = 128;

double corner(int i, int j, int k) {
    uint32_t h = uint32_t(i) * 0x9E3779B1u ^ uint32_t(j) * 0x85EBCA6Bu ^ uint32_t(k) * 0xC2B2AE35u;
    h = (h ^ h >> 15) * 0x2C1B3C6Du;
    h = (h ^ h >> 12) * 0x297A2D39u;
    return double(h ^ h >> 15) / 4294967295.0;
}

double lattice_noise(double x, double y, double z) {
    const int i = int(std::floor(x)), j = int(std::floor(y)), k = int(std::floor(z));
    const auto smooth = [](double t) { return t * t * (3 - 2 * t); };
    const std::array<double, 3> t{smooth(x - i), smooth(y - j), smooth(z - k)};
    double sum = 0;
    for (int c = 0; c < 8; ++c)
        sum += ((c & 1) ? t[0] : 1 - t[0]) * ((c & 2) ? t[1] : 1 - t[1]) * ((c & 4) ? t[2] : 1 - t[2]) *
               corner(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2));
    return sum;
}

double billows(double x, double y, double z, double frequency) {
    double sum = 0, weight = 0.5;
    for (int octave = 0; octave < 4; ++octave, frequency *= 2.1, weight *= 0.5)
        sum += weight * std::abs(2 * lattice_noise(frequency * x, frequency * y, frequency * z) - 1);
    return sum;
}

/// x, y, z in [0, 1]: heaps of balls over a flat base, their surface billowing.
double density(double x, double y, double z) {
    struct Ball {
        double x, y, z, radius;
    };
    constexpr std::array<Ball, 9> kBalls{{{0.50, 0.36, 0.50, 0.24},
                                          {0.30, 0.28, 0.46, 0.17},
                                          {0.72, 0.28, 0.52, 0.17},
                                          {0.44, 0.55, 0.47, 0.17},
                                          {0.57, 0.68, 0.52, 0.12},
                                          {0.52, 0.30, 0.26, 0.15},
                                          {0.48, 0.30, 0.74, 0.15},
                                          {0.18, 0.24, 0.50, 0.10},
                                          {0.64, 0.50, 0.40, 0.12}}};
    double inside = -1;
    for (const Ball& ball : kBalls)
        inside = std::max(inside, ball.radius - std::hypot(x - ball.x, y - ball.y, z - ball.z));
    inside -= 0.14 * (billows(x, y, z, 7) - 0.12);
    inside = std::min(inside, 1.5 * (y - 0.16));  // the base
    const double value = std::clamp(inside / 0.035, 0.0, 1.0) * (0.75 + 0.25 * lattice_noise(24 * x, 24 * y, 24 * z));
    return std::round(value * 64) / 64;  // packs well
}

}  // namespace

int main(int, char** arguments) {
    openvdb::initialize();
    auto grid = openvdb::FloatGrid::create(0.0f);
    grid->setName("density");
    grid->setTransform(openvdb::math::Transform::createLinearTransform(1.0 / kVoxels));
    grid->setGridClass(openvdb::GRID_FOG_VOLUME);
    grid->setSaveFloatAsHalf(true);
    auto write = grid->getAccessor();
    for (int i = 0; i < kVoxels; ++i)
        for (int j = 0; j < kVoxels; ++j)
            for (int k = 0; k < kVoxels; ++k) {
                const double value = density((i + 0.5) / kVoxels, (j + 0.5) / kVoxels, (k + 0.5) / kVoxels);
                // the corners are active: the active box is the whole of 128^3
                const bool is_corner = (i % (kVoxels - 1)) + (j % (kVoxels - 1)) + (k % (kVoxels - 1)) == 0;
                if (value > 0 || is_corner) write.setValue({i, j, k}, float(value));
            }
    openvdb::io::File file(arguments[1]);
    file.setCompression(openvdb::io::COMPRESS_ZIP | openvdb::io::COMPRESS_ACTIVE_MASK);
    file.write({grid});
}
