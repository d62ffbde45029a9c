// The types of costmap filters and the values of their masks.
#pragma once

#include <cstdint>

namespace nav2_costmap_2d {

static constexpr uint8_t KEEPOUT_FILTER = 0;
static constexpr uint8_t SPEED_FILTER_PERCENT = 1;
static constexpr uint8_t SPEED_FILTER_ABSOLUTE = 2;
static constexpr uint8_t BINARY_FILTER = 3;

static constexpr double BASE_DEFAULT = 0.0;
static constexpr double MULTIPLIER_DEFAULT = 1.0;

/// A speed limit of this value is none.
static constexpr double NO_SPEED_LIMIT = 0.0;

}  // namespace nav2_costmap_2d
