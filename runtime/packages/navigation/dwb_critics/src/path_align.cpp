// See path_align.hpp.
#include "dwb_critics/path_align.hpp"

#include <cmath>

#include "dwb_critics/alignment_util.hpp"
#include "nav_2d_utils/parameters.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace dwb_critics {

void PathAlignCritic::onInit() {
  PathDistCritic::onInit();
  stop_on_failure_ = false;
  const auto node = node_.lock();
  forward_point_distance_ = nav_2d_utils::searchAndGetParam(
      node, dwb_plugin_name_ + "." + name_ + ".forward_point_distance", 0.325);
}

bool PathAlignCritic::prepare(const geometry_msgs::msg::Pose2D& pose,
                              const nav_2d_msgs::msg::Twist2D& vel,
                              const geometry_msgs::msg::Pose2D& goal,
                              const nav_2d_msgs::msg::Path2D& global_plan) {
  zero_scale_ = std::hypot(pose.x - goal.x, pose.y - goal.y) <= forward_point_distance_;
  return zero_scale_ || PathDistCritic::prepare(pose, vel, goal, global_plan);
}

double PathAlignCritic::getScale() const {
  return zero_scale_ ? 0.0 : PathDistCritic::getScale();
}

double PathAlignCritic::scorePose(const geometry_msgs::msg::Pose2D& pose) {
  return PathDistCritic::scorePose(getForwardPose(pose, forward_point_distance_));
}

}  // namespace dwb_critics

PLUGINLIB_EXPORT_CLASS(dwb_critics::PathAlignCritic, dwb_core::TrajectoryCritic)
