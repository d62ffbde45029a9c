// Publishes 1, 2, 3 ...
#include <std_msgs/msg/int32.hpp>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "talk.hpp"

namespace composed_talkers {

class Counter : public rclcpp::Node {
 public:
  explicit Counter(const rclcpp::NodeOptions& options)
      : Node("counter", options),
        publisher_(create_publisher<std_msgs::msg::Int32>(kTopic, 10)),
        timer_(create_wall_timer(std::chrono::milliseconds(50), [this]() { publish(); })) {}

 private:
  void publish() {
    std_msgs::msg::Int32 message;
    message.data = ++count_;
    publisher_->publish(message);
  }

  int count_ = 0;
  rclcpp::Publisher<std_msgs::msg::Int32>::SharedPtr publisher_;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace composed_talkers

RCLCPP_COMPONENTS_REGISTER_NODE(composed_talkers::Counter)
