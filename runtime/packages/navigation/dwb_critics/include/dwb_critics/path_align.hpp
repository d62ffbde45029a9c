// How far the front of the robot is from the path at the end of a trajectory.
#pragma once

#include "dwb_critics/path_dist.hpp"

namespace dwb_critics {

class PathAlignCritic : public PathDistCritic {
 public:
  void onInit() override;
  bool prepare(const geometry_msgs::msg::Pose2D& pose, const nav_2d_msgs::msg::Twist2D& vel,
               const geometry_msgs::msg::Pose2D& goal,
               const nav_2d_msgs::msg::Path2D& global_plan) override;
  /// 0 near the goal, where the front would pass it.
  double getScale() const override;
  double scorePose(const geometry_msgs::msg::Pose2D& pose) override;

 protected:
  bool zero_scale_ = false;
  double forward_point_distance_ = 0.0;  // m
};

}  // namespace dwb_critics
