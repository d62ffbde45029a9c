// How far the robot is from the end of the local path at the end of a trajectory.
#pragma once

#include "dwb_critics/map_grid.hpp"

namespace dwb_critics {

class GoalDistCritic : public MapGridCritic {
 public:
  bool prepare(const geometry_msgs::msg::Pose2D& pose, const nav_2d_msgs::msg::Twist2D& vel,
               const geometry_msgs::msg::Pose2D& goal,
               const nav_2d_msgs::msg::Path2D& global_plan) override;

 protected:
  /// Where the path leaves the local costmap, or ends. False when no part of it is there.
  bool getLastPoseOnCostmap(const nav_2d_msgs::msg::Path2D& global_plan, unsigned int& x,
                            unsigned int& y);
};

}  // namespace dwb_critics
