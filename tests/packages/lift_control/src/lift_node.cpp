// The manager with a loop in a thread of its own, as nodes of ROS 2 run it.
#include <memory>
#include <thread>

#include "controller_manager/controller_manager.hpp"
#include "rclcpp/rclcpp.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto executor = std::make_shared<rclcpp::executors::MultiThreadedExecutor>();
  auto manager = std::make_shared<controller_manager::ControllerManager>(executor, "controller_manager");
  std::thread loop([manager] {
    const auto clock = manager->get_trigger_clock();
    rclcpp::Rate rate(manager->get_update_rate());
    auto last = clock->now();
    while (rclcpp::ok()) {
      rate.sleep();
      const auto now = clock->now();
      manager->read(now, now - last);
      manager->update(now, now - last);
      manager->write(now, now - last);
      last = now;
    }
  });
  executor->add_node(manager);
  executor->spin();
  loop.join();
  rclcpp::shutdown();
  return 0;
}
