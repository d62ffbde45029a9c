// Looks at the graph of the site for what makes a simulated robot stand still or jump, and reports
// each once: no bridge for /clock, and two publishers of one transform.
#pragma once

#include <array>
#include <map>
#include <string>

#include <tf2_msgs/msg/tf_message.hpp>

#include "rclcpp/rclcpp.hpp"

namespace ros2wasm_sim {

class WorldWatch {
 public:
  /// `needs_bridge`: /clock reaches ROS only through a bridge, as in Gazebo Sim.
  WorldWatch(rclcpp::Node::SharedPtr node, bool needs_bridge);

 private:
  using Gid = std::array<std::uint8_t, RMW_GID_STORAGE_SIZE>;
  struct Frame {
    std::string parent;
    Gid first{}, second{};
    bool has_second = false, is_reported = false;
  };

  void look();
  void look_at_clock();
  void listen(const tf2_msgs::msg::TFMessage& message, const Gid& from);
  std::string name_of(const Gid& publisher) const;

  rclcpp::Node::SharedPtr node_;
  bool looks_at_clock_;
  int looks_ = 0;
  int looks_without_clock_ = 0;
  std::map<std::string, Frame> frames_;  ///< by the child
  rclcpp::Subscription<tf2_msgs::msg::TFMessage>::SharedPtr transforms_;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace ros2wasm_sim
