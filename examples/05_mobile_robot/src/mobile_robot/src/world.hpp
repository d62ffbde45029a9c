// The walls that the robot drives among: a picture, asked for cells, for room and for how far a ray goes.
#pragma once

#include <cstdint>
#include <vector>

namespace world {

constexpr double kCell = 0.05;  ///< metres, of the map that is told
constexpr int kColumns = 200;
constexpr int kRows = 140;
/// Metres: the corner of the map with the least x and y.
constexpr double kLeft = -5.0;
constexpr double kBottom = -3.5;

/// Outside of the map everything is wall.
[[nodiscard]] bool is_wall(double x, double y);

/// Is there no wall nearer than this?
[[nodiscard]] bool has_room(double x, double y, double radius);

/// Metres from a place to the first wall in this direction, at most `farthest`.
[[nodiscard]] double ray(double x, double y, double angle, double farthest);

/// As nav_msgs/msg/OccupancyGrid has them: rows from the least y on, 100 is wall, 0 is free.
[[nodiscard]] std::vector<std::int8_t> cells();

}  // namespace world
