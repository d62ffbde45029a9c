// One turtle: where it is, what it was told, and its topics, services and action.
#pragma once

#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_action/rclcpp_action.hpp>
#include <string>
#include <vector>

#include "geometry_msgs/msg/twist.hpp"
#include "paper.hpp"
#include "turtlesim/action/rotate_absolute.hpp"
#include "turtlesim/msg/color.hpp"
#include "turtlesim/msg/pose.hpp"
#include "turtlesim/srv/set_pen.hpp"
#include "turtlesim/srv/teleport_absolute.hpp"
#include "turtlesim/srv/teleport_relative.hpp"
#include "turtlesim_scene/msg/turtle.hpp"

namespace turtlesim {

/// Sizes of the field. A unit is as many pixels as a turtle is high.
inline constexpr double kPixelsPerUnit = 45.0;
/// Single precision, which shows in the last digit of what is told: 5.544445 is the middle.
inline constexpr double kFieldUnits = static_cast<float>((Paper::kSize - 1) / kPixelsPerUnit);

class Turtle {
 public:
  /// x and y [units] from the lower left corner, theta [rad]; `shape`: how it looks.
  Turtle(rclcpp::Node& node, const std::string& name, double x, double y, double theta,
         std::uint8_t shape);

  /// Moves on by dt [s], draws, and publishes pose and colour. Says whether anything changed.
  bool update(double dt, Paper& paper, bool holonomic);
  [[nodiscard]] turtlesim_scene::msg::Turtle drawn() const;

 private:
  using Rotate = action::RotateAbsolute;
  using RotateGoal = rclcpp_action::ServerGoalHandle<Rotate>;

  struct Teleport {
    bool is_relative = false;
    double x = 0;
    double y = 0;
    double theta = 0;  ///< to turn by, when relative
    double ahead = 0;
  };

  void take(const geometry_msgs::msg::Twist& command);
  void set_pen(const srv::SetPen::Request& request);
  void accept(const std::shared_ptr<RotateGoal>& goal);
  void abort_goal(const char* reason);
  void rotate();
  void stop();
  bool teleport(const Teleport& to, Paper& paper);
  void keep_within_walls();
  void publish(const Paper& paper, bool holonomic) const;
  [[nodiscard]] PixelPoint pixel() const;

  rclcpp::Node& node_;
  std::string name_;
  std::uint8_t shape_;
  double x_;
  double down_;  ///< from the upper edge, as the texts of walls tell it
  double theta_;
  double ahead_speed_ = 0;
  double left_speed_ = 0;  ///< heeded by holonomic turtles only
  double turn_speed_ = 0;
  Pen pen_;
  bool changed_ = true;
  rclcpp::Time last_command_;
  std::vector<Teleport> teleports_;

  rclcpp::Subscription<geometry_msgs::msg::Twist>::SharedPtr commands_;
  rclcpp::Publisher<msg::Pose>::SharedPtr pose_;
  rclcpp::Publisher<msg::Color>::SharedPtr color_;
  rclcpp::Service<srv::SetPen>::SharedPtr pen_service_;
  rclcpp::Service<srv::TeleportRelative>::SharedPtr relative_service_;
  rclcpp::Service<srv::TeleportAbsolute>::SharedPtr absolute_service_;
  rclcpp_action::Server<Rotate>::SharedPtr rotate_server_;
  std::shared_ptr<RotateGoal> goal_;
  std::shared_ptr<Rotate::Result> result_;
  double goal_start_ = 0;  ///< heading when the goal came [rad]
};

}  // namespace turtlesim
