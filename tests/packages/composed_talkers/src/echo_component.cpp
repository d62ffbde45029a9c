// Says what it hears; and a component that says nothing.
#include <std_msgs/msg/int32.hpp>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "talk.hpp"

namespace composed_talkers {

class Echo : public rclcpp::Node {
 public:
  explicit Echo(const rclcpp::NodeOptions& options)
      : Node("echo", options),
        subscription_(create_subscription<std_msgs::msg::Int32>(
            kTopic, 10, [this](const std_msgs::msg::Int32& message) {
              RCLCPP_INFO(get_logger(), "heard %d", message.data);
            })) {}

 private:
  rclcpp::Subscription<std_msgs::msg::Int32>::SharedPtr subscription_;
};

class Silent : public rclcpp::Node {
 public:
  explicit Silent(const rclcpp::NodeOptions& options) : Node("silent", options) {}
};

}  // namespace composed_talkers

RCLCPP_COMPONENTS_REGISTER_NODE(composed_talkers::Echo)
RCLCPP_COMPONENTS_REGISTER_NODE(composed_talkers::Silent)
