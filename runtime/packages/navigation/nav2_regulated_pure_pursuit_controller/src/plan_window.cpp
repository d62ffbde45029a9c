// The part of the plan that counts now.
#include <algorithm>

#include "nav2_regulated_pure_pursuit_controller/regulated_pure_pursuit_controller.hpp"
#include "nav2_util/geometry_utils.hpp"
#include "nav2_util/robot_utils.hpp"

namespace nav2_regulated_pure_pursuit_controller {

using nav2_util::geometry_utils::euclidean_distance;
using nav2_util::geometry_utils::first_after_integrated_distance;
using nav2_util::geometry_utils::min_by;

geometry_msgs::msg::PoseStamped RegulatedPurePursuitController::transformed(
    const PoseStamped& pose, const std::string& frame) const {
  PoseStamped result;
  if (!nav2_util::transformPoseInTargetFrame(pose, result, *tf_, frame,
                                             params_.transform_tolerance)) {
    throw nav2_core::ControllerTFError("Unable to transform plan pose into local frame");
  }
  return result;
}

nav_msgs::msg::Path RegulatedPurePursuitController::planAhead(const PoseStamped& pose) {
  auto& poses = global_plan_.poses;
  if (poses.empty()) throw nav2_core::InvalidPath("Received plan with zero length");
  if (params_.interpolate_curvature_after_goal && poses.size() == 1) {
    throw nav2_core::InvalidPath("Received plan with length of one");
  }
  const PoseStamped robot = transformed(pose, global_plan_.header.frame_id);
  // The robot is not looked for beyond a length of the path: it may come back to this place.
  const auto search_end = first_after_integrated_distance(poses.begin(), poses.end(),
                                                          params_.max_robot_pose_search_dist);
  auto nearest = min_by(poses.begin(), search_end, [&robot](const PoseStamped& one) {
    return euclidean_distance(robot, one);
  });
  // At least two poses, as the path needs a direction.
  if (nearest != poses.begin() && nearest == std::prev(search_end) && poses.size() > 1) --nearest;
  const double extent = std::max(costmap_->getSizeInMetersX(), costmap_->getSizeInMetersY()) / 2.0;
  const auto end = std::find_if(nearest, poses.end(), [&](const PoseStamped& one) {
    return euclidean_distance(one, robot) > extent;
  });
  Path ahead;
  ahead.header.frame_id = costmap_ros_->getBaseFrameID();
  ahead.header.stamp = robot.header.stamp;
  for (auto one = nearest; one != end; ++one) {
    PoseStamped stamped = *one;
    stamped.header.frame_id = global_plan_.header.frame_id;
    stamped.header.stamp = robot.header.stamp;
    ahead.poses.push_back(transformed(stamped, ahead.header.frame_id));
    ahead.poses.back().pose.position.z = 0.0;
  }
  poses.erase(poses.begin(), nearest);
  if (ahead.poses.empty()) throw nav2_core::InvalidPath("Resulting plan has 0 poses in it.");
  return ahead;
}

}  // namespace nav2_regulated_pure_pursuit_controller
