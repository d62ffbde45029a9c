// Wait sets, guard conditions, timers, rates, sleeps.
#include <thread>

#include "checks.hpp"
#include "std_msgs/msg/string.hpp"

using std_msgs::msg::String;
using namespace std::chrono_literals;

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("waiting");
  auto node = std::make_shared<rclcpp::Node>("waiting_node");
  auto subscription = node->create_subscription<String>("bell", 10, [](const String&) {});
  auto publisher = node->create_publisher<String>("bell", 10);
  auto guard = std::make_shared<rclcpp::GuardCondition>();
  rclcpp::WaitSet wait_set({{{subscription}}}, {guard});
  CHECK(wait_set.wait(5ms).kind() == rclcpp::WaitResultKind::Timeout);
  String message;
  message.data = "hello";
  publisher->publish(message);
  {
    auto result = wait_set.wait(1s);
    CHECK(result.kind() == rclcpp::WaitResultKind::Ready);
    CHECK(result.get_wait_set().get_rcl_wait_set().subscriptions[0] != nullptr);
    CHECK(result.get_wait_set().get_rcl_wait_set().guard_conditions[0] == nullptr);
    String taken;
    rclcpp::MessageInfo info;
    CHECK(subscription->take(taken, info));
    CHECK(taken.data == "hello");
    CHECK(!subscription->take(taken, info));
  }
  guard->trigger();
  {
    auto result = wait_set.wait(1s);
    CHECK(result.get_wait_set().get_rcl_wait_set().guard_conditions[0] != nullptr);
  }
  CHECK_THROWS(std::runtime_error, wait_set.add_subscription(subscription));
  CHECK(rclcpp::WaitSet().wait(1ms).kind() == rclcpp::WaitResultKind::Empty);

  int wall = 0;
  int once = 0;
  auto wall_timer = node->create_wall_timer(2ms, [&] { ++wall; });
  rclcpp::TimerBase::SharedPtr once_timer;
  once_timer = node->create_wall_timer(1ms, [&] {
    ++once;
    once_timer->cancel();
  });
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  while (wall < 5) {
    executor.spin_once(1s);
  }
  CHECK(once == 1);
  CHECK(once_timer->is_canceled());
  CHECK(once_timer->time_until_trigger() == std::chrono::nanoseconds::max());

  const auto start = std::chrono::steady_clock::now();
  rclcpp::WallRate rate(100);
  for (int i = 0; i < 3; ++i) {
    rate.sleep();
  }
  std::this_thread::sleep_for(5ms);
  rclcpp::sleep_for(5ms);
  CHECK(std::chrono::steady_clock::now() - start >= 35ms);
  CHECK_THROWS(std::invalid_argument, rclcpp::WallRate(0.0));
  CHECK_THROWS(std::runtime_error, rclcpp::Time(1, 0, RCL_ROS_TIME) < rclcpp::Time(1, 0));
  return checks.finish();
}
