// See path_dist.hpp.
#include "dwb_critics/path_dist.hpp"

#include "nav2_costmap_2d/cost_values.hpp"
#include "nav_2d_utils/path_ops.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace dwb_critics {

bool PathDistCritic::prepare(const geometry_msgs::msg::Pose2D&, const nav_2d_msgs::msg::Twist2D&,
                             const geometry_msgs::msg::Pose2D&,
                             const nav_2d_msgs::msg::Path2D& global_plan) {
  reset();
  const nav_2d_msgs::msg::Path2D plan =
      nav_2d_utils::adjustPlanResolution(global_plan, costmap_->getResolution());
  // The part from the first pose on the local costmap until the path leaves it.
  bool is_on_costmap = false;
  for (const auto& pose : plan.poses) {
    unsigned int x = 0;
    unsigned int y = 0;
    if (costmap_->worldToMap(pose.x, pose.y, x, y) &&
        costmap_->getCost(x, y) != nav2_costmap_2d::NO_INFORMATION) {
      cell_values_[costmap_->getIndex(x, y)] = 0.0;
      queue_->enqueueCell(x, y);
      is_on_costmap = true;
    } else if (is_on_costmap) {
      break;
    }
  }
  if (!is_on_costmap) {
    RCLCPP_ERROR(rclcpp::get_logger("PathDistCritic"),
                 "None of the %zu first of %zu (%zu) points of the global plan were in the local "
                 "costmap and free",
                 plan.poses.size(), plan.poses.size(), global_plan.poses.size());
    return false;
  }
  propogateManhattanDistances();
  return true;
}

}  // namespace dwb_critics

PLUGINLIB_EXPORT_CLASS(dwb_critics::PathDistCritic, dwb_core::TrajectoryCritic)
