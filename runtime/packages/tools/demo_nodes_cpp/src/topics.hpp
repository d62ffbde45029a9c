// The two nodes that every tutorial begins with: what one says, the other hears.
#pragma once

#include <chrono>
#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <string>

#include "std_msgs/msg/string.hpp"

namespace demo_nodes_cpp {

class Talker : public rclcpp::Node {
 public:
  explicit Talker(const rclcpp::NodeOptions& options) : Node("talker", options) {
    publisher_ = create_publisher<std_msgs::msg::String>("chatter", rclcpp::QoS(7));
    timer_ = create_wall_timer(std::chrono::seconds(1), [this] { talk(); });
  }

 private:
  void talk() {
    auto message = std::make_unique<std_msgs::msg::String>();
    message->data = "Hello World: " + std::to_string(++count_);
    RCLCPP_INFO(get_logger(), "Publishing: '%s'", message->data.c_str());
    publisher_->publish(std::move(message));
  }

  std::size_t count_ = 0;
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr publisher_;
  rclcpp::TimerBase::SharedPtr timer_;
};

class Listener : public rclcpp::Node {
 public:
  explicit Listener(const rclcpp::NodeOptions& options) : Node("listener", options) {
    subscription_ = create_subscription<std_msgs::msg::String>(
        "chatter", 10, [this](const std_msgs::msg::String& message) {
          RCLCPP_INFO(get_logger(), "I heard: [%s]", message.data.c_str());
        });
  }

 private:
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr subscription_;
};

}  // namespace demo_nodes_cpp
