// See prefer_forward.hpp.
#include "dwb_critics/prefer_forward.hpp"

#include <cmath>

#include "nav_2d_utils/parameters.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace dwb_critics {

void PreferForwardCritic::onInit() {
  const auto node = node_.lock();
  const std::string prefix = dwb_plugin_name_ + "." + name_ + ".";
  const auto read = [&](const char* name, double& value) {
    value = nav_2d_utils::searchAndGetParam(node, prefix + name, value);
  };
  read("penalty", penalty_);
  read("strafe_x", strafe_x_);
  read("strafe_theta", strafe_theta_);
  read("theta_scale", theta_scale_);
}

double PreferForwardCritic::scoreTrajectory(const dwb_msgs::msg::Trajectory2D& traj) {
  const double turn = std::abs(traj.velocity.theta);
  const bool is_slow = traj.velocity.x < strafe_x_ && turn < strafe_theta_;
  return traj.velocity.x < 0.0 || is_slow ? penalty_ : turn * theta_scale_;
}

}  // namespace dwb_critics

PLUGINLIB_EXPORT_CLASS(dwb_critics::PreferForwardCritic, dwb_core::TrajectoryCritic)
