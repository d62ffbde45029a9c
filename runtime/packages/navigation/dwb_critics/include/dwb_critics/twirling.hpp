// Costs for turning.
#pragma once

#include "dwb_core/trajectory_critic.hpp"

namespace dwb_critics {

class TwirlingCritic : public dwb_core::TrajectoryCritic {
 public:
  /// The speed of the turn [rad/s].
  double scoreTrajectory(const dwb_msgs::msg::Trajectory2D& traj) override;
};

}  // namespace dwb_critics
