// See goal_dist.hpp.
#include "dwb_critics/goal_dist.hpp"

#include "nav2_costmap_2d/cost_values.hpp"
#include "nav_2d_utils/path_ops.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace dwb_critics {

bool GoalDistCritic::prepare(const geometry_msgs::msg::Pose2D&, const nav_2d_msgs::msg::Twist2D&,
                             const geometry_msgs::msg::Pose2D&,
                             const nav_2d_msgs::msg::Path2D& global_plan) {
  reset();
  unsigned int x = 0;
  unsigned int y = 0;
  if (!getLastPoseOnCostmap(global_plan, x, y)) return false;
  cell_values_[costmap_->getIndex(x, y)] = 0.0;
  queue_->enqueueCell(x, y);
  propogateManhattanDistances();
  return true;
}

bool GoalDistCritic::getLastPoseOnCostmap(const nav_2d_msgs::msg::Path2D& global_plan,
                                          unsigned int& x, unsigned int& y) {
  const nav_2d_msgs::msg::Path2D plan =
      nav_2d_utils::adjustPlanResolution(global_plan, costmap_->getResolution());
  bool is_on_costmap = false;
  for (const auto& pose : plan.poses) {
    unsigned int map_x = 0;
    unsigned int map_y = 0;
    if (costmap_->worldToMap(pose.x, pose.y, map_x, map_y) &&
        costmap_->getCost(map_x, map_y) != nav2_costmap_2d::NO_INFORMATION) {
      x = map_x;
      y = map_y;
      is_on_costmap = true;
    } else if (is_on_costmap) {
      return true;
    }
  }
  if (!is_on_costmap) {
    RCLCPP_ERROR(rclcpp::get_logger("GoalDistCritic"),
                 "None of the points of the global plan were in the local costmap.");
  }
  return is_on_costmap;
}

}  // namespace dwb_critics

PLUGINLIB_EXPORT_CLASS(dwb_critics::GoalDistCritic, dwb_core::TrajectoryCritic)
