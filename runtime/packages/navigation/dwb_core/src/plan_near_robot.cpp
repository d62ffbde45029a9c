// The part of the path that matters now.
#include <algorithm>

#include "dwb_core/dwb_local_planner.hpp"
#include "nav2_core/controller_exceptions.hpp"
#include "nav2_util/geometry_utils.hpp"
#include "nav_2d_utils/conversions.hpp"
#include "nav_2d_utils/tf_help.hpp"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

namespace dwb_core {

using geometry_msgs::msg::Pose2D;
using nav2_util::geometry_utils::euclidean_distance;
using nav_2d_msgs::msg::Path2D;
using nav_2d_msgs::msg::Pose2DStamped;

namespace {

Pose2D moved(const Pose2D& pose, const geometry_msgs::msg::TransformStamped& transform) {
  geometry_msgs::msg::Pose result;
  tf2::doTransform(nav_2d_utils::pose2DToPose(pose), result, transform);
  return nav_2d_utils::poseToPose2D(result);
}

}  // namespace

geometry_msgs::msg::TransformStamped DWBLocalPlanner::planToCostmap() const {
  const std::string frame = costmap_ros_->getGlobalFrameID();
  geometry_msgs::msg::TransformStamped same;
  same.transform.rotation.w = 1.0;
  if (frame == global_plan_.header.frame_id) return same;
  try {
    return tf_->lookupTransform(frame, global_plan_.header.frame_id, tf2::TimePointZero);
  } catch (const tf2::TransformException& error) {
    throw nav2_core::ControllerTFError(
        std::string("Unable to transform global plan into the costmap's frame: ") + error.what());
  }
}

void DWBLocalPlanner::prepareGlobalPlan(const Pose2DStamped& pose, Path2D& transformed_plan,
                                        Pose2DStamped& goal_pose, bool publish_plan) {
  transformed_plan = transformGlobalPlan(pose);
  if (publish_plan) pub_->publishTransformedPlan(transformed_plan);
  goal_pose.header.frame_id = costmap_ros_->getGlobalFrameID();
  goal_pose.pose = moved(global_plan_.poses.back(), planToCostmap());
}

Path2D DWBLocalPlanner::transformGlobalPlan(const Pose2DStamped& pose) {
  auto& poses = global_plan_.poses;
  if (poses.empty()) throw nav2_core::InvalidPath("Received plan with zero length");
  Pose2DStamped robot;
  if (!nav_2d_utils::transformPose(tf_, global_plan_.header.frame_id, pose, robot,
                                   transform_tolerance_)) {
    throw nav2_core::ControllerTFError("Unable to transform robot pose into global plan's frame");
  }
  const nav2_costmap_2d::Costmap2D& costmap = *costmap_ros_->getCostmap();
  const double half_costmap = std::max(costmap.getSizeInCellsX(), costmap.getSizeInCellsY()) *
                              costmap.getResolution() / 2.0;
  const double before = prune_plan_ ? std::min(half_costmap, prune_distance_) : half_costmap;
  const double after =
      shorten_transformed_plan_ ? std::min(half_costmap, forward_prune_distance_) : half_costmap;
  const auto distance = [&robot](const Pose2D& one) { return euclidean_distance(robot.pose, one); };

  // A path may come back to this place later: the robot is sought on its first part only.
  const auto search_end = nav2_util::geometry_utils::first_after_integrated_distance(
      poses.begin(), poses.end(), forward_prune_distance_);
  const auto first = std::find_if(poses.begin(), search_end,
                                  [&](const Pose2D& one) { return distance(one) < before; });
  const auto last =
      std::find_if(first, poses.end(), [&](const Pose2D& one) { return distance(one) > after; });

  Path2D result;
  result.header.frame_id = costmap_ros_->getGlobalFrameID();
  result.header.stamp = pose.header.stamp;
  const geometry_msgs::msg::TransformStamped transform = planToCostmap();
  std::transform(first, last, std::back_inserter(result.poses),
                 [&](const Pose2D& one) { return moved(one, transform); });
  if (result.poses.empty()) throw nav2_core::InvalidPath("Resulting plan has 0 poses in it.");
  if (prune_plan_) {
    poses.erase(poses.begin(), first);
    pub_->publishGlobalPlan(global_plan_);
  }
  return result;
}

}  // namespace dwb_core
