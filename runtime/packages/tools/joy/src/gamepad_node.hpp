// The common part of joy_node and game_controller_node: opens one of the page's gamepads and
// publishes its state on `joy`. Their texts and layouts differ.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <rclcpp/rclcpp.hpp>
#include <string>
#include <vector>

#include "gamepad_device.hpp"
#include "joy_state.hpp"
#include "sensor_msgs/msg/joy.hpp"
#include "sensor_msgs/msg/joy_feedback.hpp"

namespace joy {

class GamepadNode : public rclcpp::Node {
 protected:
  GamepadNode(const std::string& name, GamepadLayout layout, const rclcpp::NodeOptions& options);

  /// All that are connected, by their numbers.
  using Devices = std::map<int, GamepadDevice>;
  /// A gamepad was connected. `wanted` is the parameter device_name.
  virtual void say_connected(const Devices& devices, const std::string& wanted) = 0;
  virtual void say_no_device_named(const std::string& name) = 0;
  virtual void say_opened(const GamepadDevice& device, double deadzone) = 0;
  virtual void say_removed(const GamepadDevice& device) = 0;

 private:
  using Joy = sensor_msgs::msg::Joy;
  using Feedback = sensor_msgs::msg::JoyFeedback;

  void read_parameters();
  void subscribe(GamepadLayout layout);
  void take(int number, const Joy& raw);
  void add(int number, const GamepadDevice& device, const Joy& raw);
  void remove(int number);
  void follow(const Joy& raw);
  void publish();
  void rumble(const Feedback& feedback);
  void say_none();

  JoySettings settings_;
  int device_id_ = 0;
  std::string device_name_;
  std::optional<JoyState> state_;
  Devices devices_;
  /// The number of the open gamepad.
  std::optional<int> open_;
  rclcpp::Publisher<Joy>::SharedPtr publisher_;
  rclcpp::Publisher<Feedback>::SharedPtr rumble_;
  rclcpp::Subscription<Feedback>::SharedPtr feedback_;
  std::vector<rclcpp::Subscription<Joy>::SharedPtr> gamepads_;
  /// Null: nothing is repeated.
  rclcpp::TimerBase::SharedPtr repeat_;
  /// Runs while an axis that has changed waits to be published.
  rclcpp::TimerBase::SharedPtr coalesce_;
  rclcpp::TimerBase::SharedPtr patience_;
};

}  // namespace joy
