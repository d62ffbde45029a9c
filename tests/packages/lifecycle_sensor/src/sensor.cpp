// A sensor as the documentation of managed nodes shows one: it makes its publisher when it is
// configured, measures while it is active, and forgets everything when it is cleaned up.
#include <chrono>
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "rclcpp_lifecycle/lifecycle_publisher.hpp"
#include "std_msgs/msg/int32.hpp"

namespace lifecycle_sensor {

using CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;

class Sensor : public rclcpp_lifecycle::LifecycleNode {
 public:
  explicit Sensor(const rclcpp::NodeOptions& options)
      : rclcpp_lifecycle::LifecycleNode("sensor", options) {
    declare_parameter("period_ms", 20);
  }

  CallbackReturn on_configure(const rclcpp_lifecycle::State&) override {
    const auto period = get_parameter("period_ms").as_int();
    if (period <= 0) {
      RCLCPP_ERROR(get_logger(), "period_ms must be positive");
      return CallbackReturn::FAILURE;
    }
    publisher_ = create_publisher<std_msgs::msg::Int32>("measurement", 10);
    timer_ = create_wall_timer(std::chrono::milliseconds(period), [this] { measure(); });
    return CallbackReturn::SUCCESS;
  }

  CallbackReturn on_activate(const rclcpp_lifecycle::State& state) override {
    count_ = 0;
    return LifecycleNode::on_activate(state);
  }

  CallbackReturn on_cleanup(const rclcpp_lifecycle::State&) override {
    timer_.reset();
    publisher_.reset();
    return CallbackReturn::SUCCESS;
  }

  CallbackReturn on_shutdown(const rclcpp_lifecycle::State& state) override {
    RCLCPP_INFO(get_logger(), "goes off, was %s", state.label().c_str());
    timer_.reset();
    publisher_.reset();
    return CallbackReturn::SUCCESS;
  }

 private:
  void measure() {
    std_msgs::msg::Int32 message;
    message.data = ++count_;
    publisher_->publish(message);
  }

  int count_ = 0;
  std::shared_ptr<rclcpp_lifecycle::LifecyclePublisher<std_msgs::msg::Int32>> publisher_;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace lifecycle_sensor

RCLCPP_COMPONENTS_REGISTER_NODE(lifecycle_sensor::Sensor)
