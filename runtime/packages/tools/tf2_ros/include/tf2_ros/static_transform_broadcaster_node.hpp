// A node that tells where one frame is, as its parameters say.
#pragma once

#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "tf2_ros/static_transform_broadcaster.hpp"

namespace tf2_ros {

class StaticTransformBroadcasterNode final : public rclcpp::Node {
 public:
  /// Throws std::runtime_error when the two frames are the same.
  explicit StaticTransformBroadcasterNode(const rclcpp::NodeOptions& options);

 private:
  std::unique_ptr<tf2_ros::StaticTransformBroadcaster> broadcaster_;
};

}  // namespace tf2_ros
