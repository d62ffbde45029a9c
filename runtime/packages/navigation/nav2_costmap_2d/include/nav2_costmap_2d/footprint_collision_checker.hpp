// The greatest cost under the outline of a robot.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "geometry_msgs/msg/pose2_d.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "nav2_costmap_2d/costmap_2d.hpp"
#include "nav2_util/robot_utils.hpp"
#include "rclcpp/rclcpp.hpp"

namespace nav2_costmap_2d {

typedef std::vector<geometry_msgs::msg::Point> Footprint;

/// `CostmapT` is a pointer, or a shared one, to a Costmap2D.
template <typename CostmapT>
class FootprintCollisionChecker {
 public:
  FootprintCollisionChecker();
  explicit FootprintCollisionChecker(CostmapT costmap);

  /// The outline is in the world. LETHAL_OBSTACLE where it leaves the map.
  double footprintCost(const Footprint& footprint);
  double footprintCostAtPose(double x, double y, double theta, const Footprint& footprint);
  /// Along a line between two cells, both included.
  double lineCost(int x0, int x1, int y0, int y1) const;
  bool worldToMap(double wx, double wy, unsigned int& mx, unsigned int& my);
  double pointCost(int x, int y) const;
  void setCostmap(CostmapT costmap);
  CostmapT getCostmap() { return costmap_; }

 protected:
  CostmapT costmap_;
};

}  // namespace nav2_costmap_2d
