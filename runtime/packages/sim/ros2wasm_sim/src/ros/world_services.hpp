// The services of a world below /_gz/world/NAME, by which bridges, `create` and the page act on it:
// the same with both servers.
#pragma once

#include <ros_gz_interfaces/srv/control_world.hpp>
#include <ros_gz_interfaces/srv/delete_entity.hpp>
#include <ros_gz_interfaces/srv/set_entity_pose.hpp>
#include <ros_gz_interfaces/srv/spawn_entity.hpp>

#include <functional>
#include <string>
#include <vector>

#include "ros/host.hpp"
#include "ros/runner.hpp"

namespace ros2wasm_sim {

class WorldServices {
 public:
  /// `after_reset` is called when time has gone back to 0.
  WorldServices(Host& host, Simulation& simulation, Runner& runner,
                std::function<void()> after_reset);

 private:
  template <typename Service, typename Answer>
  void offer(const std::string& name, Answer answer);
  bool create(const ros_gz_interfaces::msg::EntityFactory& factory);
  bool remove(const ros_gz_interfaces::msg::Entity& entity);
  void control(const ros_gz_interfaces::msg::WorldControl& control);

  Host& host_;
  Simulation& simulation_;
  Runner& runner_;
  std::function<void()> after_reset_;
  std::vector<rclcpp::ServiceBase::SharedPtr> services_;
};

}  // namespace ros2wasm_sim
