// The field with its turtles: parameters, services, the clock of all, and what the page draws.
#pragma once

#include <map>
#include <memory>
#include <random>
#include <string>

#include "paper.hpp"
#include "rcl_interfaces/msg/parameter_event.hpp"
#include "std_srvs/srv/empty.hpp"
#include "turtle.hpp"
#include "turtlesim/srv/kill.hpp"
#include "turtlesim/srv/spawn.hpp"
#include "turtlesim_scene/msg/scene.hpp"
#include "turtlesim_scene/srv/get_picture.hpp"

namespace turtlesim {

class Simulator {
 public:
  explicit Simulator(rclcpp::Node::SharedPtr node);

 private:
  using Scene = turtlesim_scene::msg::Scene;
  using GetPicture = turtlesim_scene::srv::GetPicture;

  void declare_parameters();
  void create_services();
  /// Returns the name, empty when the turtle was refused. No name: the next free one.
  std::string spawn(const std::string& name, double x, double y, double theta);
  void spawn_first();
  void kill(const std::string& name);
  void update();
  void publish_scene();
  void fill_picture(GetPicture::Response& response) const;

  rclcpp::Node::SharedPtr node_;
  Paper paper_;
  std::map<std::string, std::unique_ptr<Turtle>> turtles_;
  int last_number_ = 0;  ///< of turtles that nobody named
  bool changed_ = true;  ///< since the last scene
  std::minstd_rand shapes_;
  rclcpp::Publisher<Scene>::SharedPtr scene_;
  rclcpp::Subscription<rcl_interfaces::msg::ParameterEvent>::SharedPtr parameter_events_;
  rclcpp::Service<std_srvs::srv::Empty>::SharedPtr clear_service_;
  rclcpp::Service<std_srvs::srv::Empty>::SharedPtr reset_service_;
  rclcpp::Service<srv::Spawn>::SharedPtr spawn_service_;
  rclcpp::Service<srv::Kill>::SharedPtr kill_service_;
  rclcpp::Service<GetPicture>::SharedPtr picture_service_;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace turtlesim
