#include "froxels/froxel_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "light_rectangle.h"

namespace tyndall::participating_media {
namespace {

float view_depth(const FrameBlock& block, const glm::vec3& p) {
    return -(block.view * glm::vec4(p, 1.0f)).z;
}

}  // namespace

int FroxelGrid::slice(float metres) const {
    const float share = std::log(1.0f + std::max(metres - begin_m, 0.0f) / spread_m) / growth;
    return static_cast<int>(std::floor(std::min(share, 2.0f) * static_cast<float>(size.z)));
}

FroxelGrid fit_grid(const FroxelSettings& settings, const Frame& frame, const std::vector<Medium>& media,
                    const std::vector<Term>& terms) {
    float nearest = std::numeric_limits<float>::max(), farthest = 0.0f;
    for (const Term& term : terms) {
        const glm::mat4 box = medium_box(media[term.medium], frame.scene);
        for (int i = 0; i < 8; ++i) {
            const glm::vec4 corner(static_cast<float>(i & 1) - 0.5f, static_cast<float>(i >> 1 & 1) - 0.5f,
                                   static_cast<float>(i >> 2) - 0.5f, 1.0f);
            const float depth = view_depth(frame.block, glm::vec3(box * corner));
            nearest = std::min(nearest, depth);
            farthest = std::max(farthest, depth);
        }
    }
    FroxelGrid grid;
    grid.size = {settings.width, settings.height, settings.depth};
    if (settings.reference) grid.size = {(frame.block.size_time.x + 1) / 2, (frame.block.size_time.y + 1) / 2, 256};
    grid.begin_m = std::clamp(nearest, 0.0f, 0.5f * settings.range_m);
    grid.end_m = std::max(std::min(farthest, settings.range_m), grid.begin_m + 1e-2f);
    grid.complete = farthest <= settings.range_m;
    grid.spread_m = grid.begin_m + settings.even_m;
    grid.growth = std::log(1.0f + (grid.end_m - grid.begin_m) / grid.spread_m);
    return grid;
}

FroxelBox light_box(const FroxelGrid& grid, const Light& light, const FrameBlock& block) {
    const ScreenRectangle columns = light_rectangle(light, block.view_projection, glm::ivec2(grid.size));
    FroxelBox box{glm::ivec3(columns.low, 0), glm::ivec3(columns.size, grid.size.z)};
    if (light.kind == LightKind::directional || light.range_m <= 0.0f) return box;
    const float depth = view_depth(block, glm::vec3(light.transform[3]));
    if (depth + light.range_m < grid.begin_m) return {};
    box.low.z = std::min(grid.slice(depth - light.range_m), grid.size.z);
    box.size.z = std::min(grid.slice(depth + light.range_m) + 1, grid.size.z) - box.low.z;
    return box;
}

}  // namespace tyndall::participating_media
