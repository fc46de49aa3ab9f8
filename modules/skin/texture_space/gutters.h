#pragma once
/// What lies across the borders of charts.

#include <vector>

#include "texture_space/atlas.h"
#include "texture_space/charts.h"
#include "texture_space/metric.h"

namespace tyndall::skin {

/// Adds the gutters to an atlas that has its texels. `owners`: the chart of each texel of the map, 0 = none.
void add_gutters(const Mesh& mesh, const Charts& charts, const std::vector<Metric>& metrics,
                 const std::vector<uint32_t>& owners, Atlas& atlas);

}  // namespace tyndall::skin
