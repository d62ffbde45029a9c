// See goal_align.hpp.
#include "dwb_critics/goal_align.hpp"

#include <cmath>

#include "dwb_critics/alignment_util.hpp"
#include "nav_2d_utils/parameters.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace dwb_critics {

void GoalAlignCritic::onInit() {
  GoalDistCritic::onInit();
  stop_on_failure_ = false;
  const auto node = node_.lock();
  forward_point_distance_ = nav_2d_utils::searchAndGetParam(
      node, dwb_plugin_name_ + "." + name_ + ".forward_point_distance", 0.325);
}

bool GoalAlignCritic::prepare(const geometry_msgs::msg::Pose2D& pose,
                              const nav_2d_msgs::msg::Twist2D& vel,
                              const geometry_msgs::msg::Pose2D& goal,
                              const nav_2d_msgs::msg::Path2D& global_plan) {
  if (global_plan.poses.empty()) return false;
  // On the line from the robot to the goal: the front is not drawn around the goal yet.
  geometry_msgs::msg::Pose2D towards;
  towards.theta = std::atan2(goal.y - pose.y, goal.x - pose.x);
  const geometry_msgs::msg::Pose2D ahead = getForwardPose(towards, forward_point_distance_);
  nav_2d_msgs::msg::Path2D plan = global_plan;
  plan.poses.back().x += ahead.x;
  plan.poses.back().y += ahead.y;
  return GoalDistCritic::prepare(pose, vel, goal, plan);
}

double GoalAlignCritic::scorePose(const geometry_msgs::msg::Pose2D& pose) {
  return GoalDistCritic::scorePose(getForwardPose(pose, forward_point_distance_));
}

}  // namespace dwb_critics

PLUGINLIB_EXPORT_CLASS(dwb_critics::GoalAlignCritic, dwb_core::TrajectoryCritic)
