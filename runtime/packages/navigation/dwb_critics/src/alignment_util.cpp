// See alignment_util.hpp.
#include "dwb_critics/alignment_util.hpp"

#include <cmath>

namespace dwb_critics {

geometry_msgs::msg::Pose2D getForwardPose(const geometry_msgs::msg::Pose2D& pose, double distance) {
  geometry_msgs::msg::Pose2D result = pose;
  result.x += distance * std::cos(pose.theta);
  result.y += distance * std::sin(pose.theta);
  return result;
}

}  // namespace dwb_critics
