// A room of 8 by 6 m with two blocks: its map, what a laser sees in it, and a robot that drives
// through it. For the tests of nav2_amcl.
#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "nav2_amcl/map/occupancy_map.hpp"
#include "nav2_amcl/motion_model/differential_motion_model.hpp"
#include "nav2_amcl/pf/particle_filter.hpp"
#include "nav2_amcl/sensors/laser_model.hpp"

namespace amcl_room {

using nav2_amcl::CellState;
using nav2_amcl::OccupancyMap;

inline constexpr double kResolution = 0.05;
inline constexpr int kWidth = 160;
inline constexpr int kHeight = 120;

inline bool is_block(int x, int y) {
  const bool is_border = x == 0 || y == 0 || x == kWidth - 1 || y == kHeight - 1;
  const bool is_first = x >= 40 && x < 60 && y >= 80 && y < 100;
  const bool is_second = x >= 110 && x < 120 && y >= 20 && y < 50;
  return is_border || is_first || is_second;
}

/// The origin is the lower left corner.
inline std::shared_ptr<OccupancyMap> room() {
  std::vector<CellState> cells;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      cells.push_back(is_block(x, y) ? CellState::Occupied : CellState::Free);
    }
  }
  return std::make_shared<OccupancyMap>(
      nav2_amcl::MapGeometry{kWidth, kHeight, kResolution, 0.0, 0.0}, std::move(cells));
}

/// Ranges with noise, by a walk along the ray in steps of 2 cm. Of the beams of a scan only those
/// are measured that models with 60 beams look at.
inline nav2_amcl::LaserData scan_at(const OccupancyMap& map, const pf_vector_t& pose, int count,
                                    nav2_amcl::Random& random) {
  nav2_amcl::LaserData data;
  data.range_max = 10.0;
  for (int i = 0; i < count; ++i) {
    const double bearing = -M_PI + 2 * M_PI * i / count;
    double range = i % (count / 60) == 0 ? 0.0 : std::numeric_limits<double>::quiet_NaN();
    while (range < data.range_max) {
      const auto cell = map.cell_at(pose.v[0] + range * std::cos(pose.v[2] + bearing),
                                    pose.v[1] + range * std::sin(pose.v[2] + bearing));
      if (!cell || map.state(*cell) != CellState::Free) break;
      range += 0.02;
    }
    data.beams.push_back({range + 0.01 * random.gaussian(), bearing});
  }
  return data;
}

/// Drives forward, with the odometry of its wheels.
class Robot {
 public:
  Robot(const pf_vector_t& pose, nav2_amcl::Random& random) : pose_(pose), random_(random) {}

  const pf_vector_t& pose() const { return pose_; }
  const pf_vector_t& odometry() const { return odometry_; }

  void drive(double length) {
    advance(pose_, length);
    advance(odometry_, length * (1 + 0.02 * random_.gaussian()));
  }
  void turn(double angle) {
    pose_.v[2] += angle;
    odometry_.v[2] += angle * (1 + 0.02 * random_.gaussian());
  }

 private:
  static void advance(pf_vector_t& pose, double length) {
    pose.v[0] += length * std::cos(pose.v[2]);
    pose.v[1] += length * std::sin(pose.v[2]);
  }

  pf_vector_t pose_;
  pf_vector_t odometry_{};
  nav2_amcl::Random& random_;
};

}  // namespace amcl_room
