// See obstacle_footprint.hpp.
#include "dwb_critics/obstacle_footprint.hpp"

#include <algorithm>

#include "dwb_core/exceptions.hpp"
#include "dwb_critics/line_iterator.hpp"
#include "nav2_costmap_2d/cost_values.hpp"
#include "nav2_costmap_2d/footprint.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace dwb_critics {

using dwb_core::IllegalTrajectoryException;
using geometry_msgs::msg::Pose2D;

Footprint getOrientedFootprint(const Pose2D& pose, const Footprint& footprint_spec) {
  Footprint result;
  nav2_costmap_2d::transformFootprint(pose.x, pose.y, pose.theta, footprint_spec, result);
  return result;
}

bool ObstacleFootprintCritic::prepare(const Pose2D&, const nav_2d_msgs::msg::Twist2D&,
                                      const Pose2D&, const nav_2d_msgs::msg::Path2D&) {
  footprint_spec_ = costmap_ros_->getRobotFootprint();
  if (!footprint_spec_.empty()) return true;
  RCLCPP_ERROR(rclcpp::get_logger("ObstacleFootprintCritic"),
               "Footprint spec is empty, maybe missing call to setFootprint?");
  return false;
}

double ObstacleFootprintCritic::scorePose(const Pose2D& pose) {
  unsigned int x = 0;
  unsigned int y = 0;
  if (!costmap_->worldToMap(pose.x, pose.y, x, y)) {
    throw IllegalTrajectoryException(name_, "Trajectory Goes Off Grid.");
  }
  return scorePose(pose, getOrientedFootprint(pose, footprint_spec_));
}

double ObstacleFootprintCritic::scorePose(const Pose2D&, const Footprint& footprint) {
  if (footprint.empty()) throw IllegalTrajectoryException(name_, "Footprint Is Empty.");
  double cost = 0.0;
  for (size_t i = 0; i < footprint.size(); ++i) {
    const auto& from = footprint[i];
    const auto& to = footprint[(i + 1) % footprint.size()];
    unsigned int x0 = 0;
    unsigned int y0 = 0;
    unsigned int x1 = 0;
    unsigned int y1 = 0;
    if (!costmap_->worldToMap(from.x, from.y, x0, y0) ||
        !costmap_->worldToMap(to.x, to.y, x1, y1)) {
      throw IllegalTrajectoryException(name_, "Footprint Goes Off Grid.");
    }
    cost = std::max(cost, lineCost(static_cast<int>(x0), static_cast<int>(x1), static_cast<int>(y0),
                                   static_cast<int>(y1)));
  }
  return cost;
}

double ObstacleFootprintCritic::lineCost(int x0, int x1, int y0, int y1) {
  double cost = 0.0;
  for (LineIterator line(x0, y0, x1, y1); line.isValid(); line.advance()) {
    cost = std::max(cost, pointCost(line.getX(), line.getY()));
  }
  return cost;
}

double ObstacleFootprintCritic::pointCost(int x, int y) {
  const unsigned char cost =
      costmap_->getCost(static_cast<unsigned int>(x), static_cast<unsigned int>(y));
  if (cost == nav2_costmap_2d::LETHAL_OBSTACLE) {
    throw IllegalTrajectoryException(name_, "Trajectory Hits Obstacle.");
  }
  if (cost == nav2_costmap_2d::NO_INFORMATION) {
    throw IllegalTrajectoryException(name_, "Trajectory Hits Unknown Region.");
  }
  return cost;
}

}  // namespace dwb_critics

PLUGINLIB_EXPORT_CLASS(dwb_critics::ObstacleFootprintCritic, dwb_core::TrajectoryCritic)
