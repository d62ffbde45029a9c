// Publishes /clock ten times as fast as time goes by, for sim_time.cpp.
#include "checks.hpp"
#include "rosgraph_msgs/msg/clock.hpp"
#include "std_msgs/msg/empty.hpp"

using namespace std::chrono_literals;

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("sim_clock");
  auto node = std::make_shared<rclcpp::Node>("sim_clock");
  auto clock = node->create_publisher<rosgraph_msgs::msg::Clock>("/clock", rclcpp::ClockQoS());
  bool done = false;
  auto subscription = node->create_subscription<std_msgs::msg::Empty>(
      "sim_done", rclcpp::QoS(1).transient_local(),
      [&](const std_msgs::msg::Empty&) { done = true; });
  rclcpp::Time now(100, 0, RCL_ROS_TIME);
  auto timer = node->create_wall_timer(5ms, [&] {
    now += rclcpp::Duration(50ms);
    rosgraph_msgs::msg::Clock message;
    message.clock = now;
    clock->publish(message);
  });
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  while (!done) {
    executor.spin_once();
  }
  CHECK(now.seconds() > 108);
  return checks.finish();
}
