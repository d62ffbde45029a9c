// The node that hands an entity to Gazebo Classic.
#pragma once

#include <optional>
#include <string>

#include "arguments.hpp"
#include "geometry_msgs/msg/pose.hpp"
#include "rclcpp/rclcpp.hpp"

namespace gazebo_ros {

class Spawner {
 public:
  explicit Spawner(Arguments arguments);

  /// Returns the exit code.
  int run();

 private:
  void wait_for_entity();
  /// The description of the entity; nothing when there is none, which is reported.
  std::optional<std::string> description();
  std::optional<std::string> text_of_file();
  std::optional<std::string> text_of_topic();
  bool spawn(const std::string& text);
  void remove();
  /// Calls a service of Gazebo that takes nothing.
  void call_empty(const std::string& name);
  /// Waits for the answer. Null: the service is not there, or the program ends.
  template <typename Service>
  typename Service::Response::SharedPtr call(const std::string& name, double timeout_s,
                                             const char* provider,
                                             typename Service::Request::SharedPtr request);
  geometry_msgs::msg::Pose pose() const;

  Arguments arguments_;
  rclcpp::Node::SharedPtr node_;
  rclcpp::executors::SingleThreadedExecutor executor_;
};

}  // namespace gazebo_ros
