// The values of cells in a costmap, and how a layer joins its values to those below it.
#pragma once

namespace nav2_costmap_2d {

static constexpr unsigned char NO_INFORMATION = 255;
static constexpr unsigned char LETHAL_OBSTACLE = 254;
static constexpr unsigned char INSCRIBED_INFLATED_OBSTACLE = 253;
static constexpr unsigned char MAX_NON_OBSTACLE = 252;
static constexpr unsigned char FREE_SPACE = 0;

enum class CombinationMethod : int { Overwrite = 0, Max = 1, MaxWithoutUnknownOverwrite = 2 };

}  // namespace nav2_costmap_2d
