// use_sim_time: the clock, timers, sleeps, rates and jump callbacks of a node follow /clock, which
// another program publishes (sim_clock.cpp).

// Compatibility, works: `use_sim_time` and `/clock`: clocks, ROS timers, sleeps, rates and jump
// callbacks

#include "checks.hpp"
#include "std_msgs/msg/empty.hpp"

using namespace std::chrono_literals;

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("sim_time");
  auto node = std::make_shared<rclcpp::Node>(
      "sim_time", rclcpp::NodeOptions().parameter_overrides({{"use_sim_time", true}}));
  const auto clock = node->get_clock();
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  const auto simulated = [&] {
    return clock->now().seconds() >= 100 && clock->now().seconds() < 10000;
  };

  CHECK(clock->ros_time_is_active());
  CHECK(clock->wait_until_started());
  CHECK(simulated());

  int forward = 0;
  int backward = 0;
  int switched = 0;
  rcl_jump_threshold_t threshold{true, {1}, {-1}};
  const auto handler = clock->create_jump_callback(
      [] {},
      [&](const rcl_time_jump_t& jump) {
        const bool change = jump.clock_change != RCL_ROS_TIME_NO_CHANGE;
        ++(change ? switched : jump.delta.nanoseconds > 0 ? forward : backward);
      },
      threshold);

  auto before = clock->now();
  CHECK(clock->sleep_for(rclcpp::Duration(2s)));
  CHECK(clock->now() - before >= rclcpp::Duration(2s));
  CHECK(forward > 0);
  CHECK(backward == 0);

  before = clock->now();
  rclcpp::Rate rate(1.0, clock);
  rate.sleep();
  rate.sleep();
  CHECK(clock->now() - before > rclcpp::Duration(1s));

  int fired = 0;
  before = clock->now();
  const auto timer = node->create_timer(1s, [&] { ++fired; });
  while (fired < 5) {
    executor.spin_once();
  }
  CHECK(clock->now() - before >= rclcpp::Duration(5s));
  CHECK(!timer->is_steady());

  node->set_parameter({"use_sim_time", false});
  CHECK(!clock->ros_time_is_active());
  CHECK(!simulated());
  CHECK(switched == 1);

  // Until the other program knows it.
  auto done =
      node->create_publisher<std_msgs::msg::Empty>("sim_done", rclcpp::QoS(1).transient_local());
  done->publish(std_msgs::msg::Empty());
  while (node->count_publishers("/clock") > 0) {
    executor.spin_once(10ms);
  }
  return checks.finish();
}
