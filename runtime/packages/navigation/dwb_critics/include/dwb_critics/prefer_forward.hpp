// Costs for driving back, for standing, and for turning.
#pragma once

#include "dwb_core/trajectory_critic.hpp"

namespace dwb_critics {

class PreferForwardCritic : public dwb_core::TrajectoryCritic {
 public:
  void onInit() override;
  double scoreTrajectory(const dwb_msgs::msg::Trajectory2D& traj) override;

 private:
  double penalty_ = 1.0;
  // Slower than both counts as standing or going sideways.
  double strafe_x_ = 0.1;      // m/s
  double strafe_theta_ = 0.2;  // rad/s
  double theta_scale_ = 10.0;  // per rad/s
};

}  // namespace dwb_critics
