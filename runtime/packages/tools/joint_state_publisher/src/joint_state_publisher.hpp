// A node that tells the state of all joints of a robot, again and again.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "joints.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/joint_state.hpp"
#include "std_msgs/msg/string.hpp"

namespace joint_state_publisher {

class JointStatePublisher : public rclcpp::Node {
 public:
  /// With a file the description is read from there, else it comes by topic.
  explicit JointStatePublisher(const std::optional<std::string>& urdf_file);

 private:
  void configure(const std::string& description);
  void publish();

  std::optional<Joints> joints_;
  double delta_ = 0;
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr description_;
  std::vector<rclcpp::Subscription<sensor_msgs::msg::JointState>::SharedPtr> sources_;
  rclcpp::Publisher<sensor_msgs::msg::JointState>::SharedPtr publisher_;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace joint_state_publisher
