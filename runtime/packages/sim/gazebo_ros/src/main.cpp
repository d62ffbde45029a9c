// spawn_entity.py: puts an entity into the world of Gazebo Classic, and ends.
#include <iostream>

#include "arguments.hpp"
#include "rclcpp/rclcpp.hpp"
#include "spawner.hpp"

int main(int argc, char** argv) {
  auto words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  if (!words.empty()) words.erase(words.begin());
  auto read = gazebo_ros::read_arguments(words);
  if (!read.arguments) {
    (read.exit_code == 0 ? std::cout : std::cerr) << read.text << std::flush;
    rclcpp::shutdown();
    return read.exit_code;
  }
  const int exit_code = gazebo_ros::Spawner(std::move(*read.arguments)).run();
  rclcpp::shutdown();
  return exit_code;
}
