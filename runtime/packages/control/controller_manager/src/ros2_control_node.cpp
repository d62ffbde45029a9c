// The program: a manager, and a loop at its rate. The loop is a timer of the executor, so the
// program has one thread and runs on every link; calls of services come between two cycles.
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "controller_manager/controller_manager.hpp"
#include "rclcpp/executors.hpp"
#include "rclcpp/utilities.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  const auto executor = std::make_shared<rclcpp::executors::SingleThreadedExecutor>();
  rclcpp::NodeOptions options = controller_manager::get_cm_node_options();
  std::vector<std::string> arguments = options.arguments();
  for (int i = 1; i < argc; ++i) {
    if (!arguments.empty() || std::string(argv[i]) == "--ros-args") {
      arguments.emplace_back(argv[i]);
    }
  }
  options.arguments(arguments);
  const auto manager = std::make_shared<controller_manager::ControllerManager>(
      executor, "controller_manager", "", options);
  RCLCPP_INFO(manager->get_logger(), "update rate is %u Hz", manager->get_update_rate());
  RCLCPP_INFO(manager->get_logger(), "Overruns handling is : %s",
              manager->get_parameter_or("overruns.manage", true) ? "enabled" : "disabled");

  const auto clock = manager->get_trigger_clock();
  rclcpp::Time last = clock->now();
  const auto cycle = [&manager, &clock, &last] {
    const rclcpp::Time now = clock->now();
    const rclcpp::Duration period = now - last;
    const bool has_just_started = last.nanoseconds() == 0;
    last = now;
    if (has_just_started || period.nanoseconds() <= 0) {
      return;  // the first tick of simulated time, or a clock that was set back
    }
    manager->read(now, period);
    manager->update(now, period);
    manager->write(now, period);
  };
  const std::chrono::nanoseconds period(1000000000 / manager->get_update_rate());
  const auto timer = rclcpp::create_timer(manager, clock, rclcpp::Duration(period), cycle);
  executor->add_node(manager);
  executor->spin();
  rclcpp::shutdown();
  return 0;
}
