// The cost under the centre of the robot, which forbids obstacles and unknown cells.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "dwb_core/trajectory_critic.hpp"

namespace dwb_critics {

class BaseObstacleCritic : public dwb_core::TrajectoryCritic {
 public:
  void onInit() override;
  /// The cost of the last pose; with `sum_scores` the sum of all.
  double scoreTrajectory(const dwb_msgs::msg::Trajectory2D& traj) override;
  void addCriticVisualization(
      std::vector<std::pair<std::string, std::vector<float>>>& cost_channels) override;
  virtual double scorePose(const geometry_msgs::msg::Pose2D& pose);
  virtual bool isValidCost(const unsigned char cost);

 protected:
  nav2_costmap_2d::Costmap2D* costmap_ = nullptr;
  bool sum_scores_ = false;
};

}  // namespace dwb_critics
