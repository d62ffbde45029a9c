// See turtle.hpp.
#include "turtle.hpp"

#include <algorithm>
#include <cmath>

namespace turtlesim {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// The same heading within [-pi, pi).
double normalized(double angle) {
  return angle - 2 * kPi * std::floor((angle + kPi) / (2 * kPi));
}

}  // namespace

Turtle::Turtle(rclcpp::Node& node, const std::string& name, double x, double y, double theta,
               std::uint8_t shape)
    : node_(node),
      name_(name),
      shape_(shape),
      x_(x),
      down_(kFieldUnits - y),
      theta_(theta),
      last_command_(node.now()) {
  const rclcpp::QoS latest(1);
  commands_ = node.create_subscription<geometry_msgs::msg::Twist>(
      name + "/cmd_vel", latest,
      [this](const geometry_msgs::msg::Twist& command) { take(command); });
  pose_ = node.create_publisher<msg::Pose>(name + "/pose", latest);
  color_ = node.create_publisher<msg::Color>(name + "/color_sensor", latest);
  pen_service_ = node.create_service<srv::SetPen>(
      name + "/set_pen", [this](const srv::SetPen::Request::SharedPtr request,
                                srv::SetPen::Response::SharedPtr) { set_pen(*request); });
  // Callers are answered before the turtle has moved.
  relative_service_ = node.create_service<srv::TeleportRelative>(
      name + "/teleport_relative", [this](const srv::TeleportRelative::Request::SharedPtr request,
                                          srv::TeleportRelative::Response::SharedPtr) {
        teleports_.push_back(
            {.is_relative = true, .theta = request->angular, .ahead = request->linear});
      });
  absolute_service_ = node.create_service<srv::TeleportAbsolute>(
      name + "/teleport_absolute", [this](const srv::TeleportAbsolute::Request::SharedPtr request,
                                          srv::TeleportAbsolute::Response::SharedPtr) {
        teleports_.push_back({.x = request->x, .y = request->y, .theta = request->theta});
      });
  rotate_server_ = rclcpp_action::create_server<Rotate>(
      &node, name + "/rotate_absolute",
      [](const rclcpp_action::GoalUUID&, const std::shared_ptr<const Rotate::Goal>&) {
        return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
      },
      [](const std::shared_ptr<RotateGoal>&) { return rclcpp_action::CancelResponse::ACCEPT; },
      [this](const std::shared_ptr<RotateGoal>& goal) { accept(goal); });
}

void Turtle::take(const geometry_msgs::msg::Twist& command) {
  if (goal_) abort_goal("Velocity command received during rotation goal. Aborting goal");
  last_command_ = node_.now();
  ahead_speed_ = command.linear.x;
  left_speed_ = command.linear.y;
  turn_speed_ = command.angular.z;
}

void Turtle::set_pen(const srv::SetPen::Request& request) {
  changed_ = true;
  pen_.is_on = request.off == 0;
  if (!pen_.is_on) return;
  pen_.color = {request.r, request.g, request.b};
  pen_.width = request.width == 0 ? 1 : request.width;
}

void Turtle::accept(const std::shared_ptr<RotateGoal>& goal) {
  if (goal_) {
    abort_goal("Rotation goal received before a previous goal finished. Aborting previous goal");
  }
  goal_ = goal;
  result_ = std::make_shared<Rotate::Result>();
  goal_start_ = theta_;
}

void Turtle::abort_goal(const char* reason) {
  RCLCPP_WARN(node_.get_logger(), "%s", reason);
  goal_->abort(result_);
  goal_.reset();
}

void Turtle::stop() {
  ahead_speed_ = 0;
  left_speed_ = 0;
  turn_speed_ = 0;
}

void Turtle::rotate() {
  constexpr double kNearEnough = 0.02;  // [rad]
  constexpr double kSpeed = 1.0;        // [rad/s]
  if (goal_->is_canceling()) {
    RCLCPP_INFO(node_.get_logger(), "Rotation goal canceled");
    goal_->canceled(result_);
    goal_.reset();
    stop();
    return;
  }
  const double remaining = normalized(goal_->get_goal()->theta - theta_);
  result_->delta = static_cast<float>(normalized(goal_start_ - theta_));
  const auto feedback = std::make_shared<Rotate::Feedback>();
  feedback->remaining = static_cast<float>(remaining);
  goal_->publish_feedback(feedback);
  if (std::abs(remaining) < kNearEnough) {
    RCLCPP_INFO(node_.get_logger(), "Rotation goal completed successfully");
    goal_->succeed(result_);
    goal_.reset();
    stop();
    return;
  }
  stop();
  turn_speed_ = remaining < 0 ? -kSpeed : kSpeed;
  last_command_ = node_.now();
}

PixelPoint Turtle::pixel() const {
  return {x_ * kPixelsPerUnit, down_ * kPixelsPerUnit};
}

bool Turtle::teleport(const Teleport& to, Paper& paper) {
  const PixelPoint before = pixel();
  if (to.is_relative) {
    theta_ += to.theta;
    x_ += std::cos(theta_) * to.ahead;
    down_ -= std::sin(theta_) * to.ahead;
  } else {
    x_ = to.x;
    down_ = std::max(0.0, kFieldUnits - to.y);
    theta_ = to.theta;
  }
  if (pen_.is_on) paper.draw(before, pixel(), pen_);
  return true;
}

void Turtle::keep_within_walls() {
  const auto inside = [](double value) { return value >= 0 && value <= kFieldUnits; };
  if (inside(x_) && inside(down_)) return;
  RCLCPP_WARN(node_.get_logger(), "Oh no! I hit the wall! (Clamping from [x=%f, y=%f])", x_, down_);
  // A NaN is set to the middle of the field: else it would stay NaN for ever.
  const auto clamped = [](double value) {
    return std::isnan(value) ? kFieldUnits / 2 : std::clamp(value, 0.0, kFieldUnits);
  };
  x_ = clamped(x_);
  down_ = clamped(down_);
}

bool Turtle::update(double dt, Paper& paper, bool holonomic) {
  const double theta_before = theta_;
  bool changed = std::exchange(changed_, false);
  for (const Teleport& one : std::exchange(teleports_, {})) changed |= teleport(one, paper);
  if (node_.now() - last_command_ > rclcpp::Duration(1, 0)) stop();
  if (goal_) rotate();

  const PixelPoint before = pixel();
  theta_ = normalized(theta_ + turn_speed_ * dt);
  if (!std::isfinite(theta_)) theta_ = 0;
  x_ += std::cos(theta_) * ahead_speed_ * dt;
  down_ -= std::sin(theta_) * ahead_speed_ * dt;
  if (holonomic) {
    x_ -= std::sin(theta_) * left_speed_ * dt;
    down_ -= std::cos(theta_) * left_speed_ * dt;
  }
  keep_within_walls();
  publish(paper, holonomic);
  const PixelPoint now = pixel();
  const bool moved = now.x != before.x || now.y != before.y;
  if (moved && pen_.is_on) paper.draw(before, now, pen_);
  return changed || moved || theta_ != theta_before;
}

void Turtle::publish(const Paper& paper, bool holonomic) const {
  msg::Pose pose;
  pose.x = static_cast<float>(x_);
  pose.y = static_cast<float>(kFieldUnits - down_);
  pose.theta = static_cast<float>(theta_);
  // Without its direction: a turtle that goes back tells what one tells that goes ahead.
  pose.linear_velocity =
      static_cast<float>(std::hypot(ahead_speed_, holonomic ? left_speed_ : 0.0));
  pose.angular_velocity = static_cast<float>(turn_speed_);
  pose_->publish(pose);
  const Rgb under = paper.color_at(pixel());
  msg::Color color;
  color.r = under.r;
  color.g = under.g;
  color.b = under.b;
  color_->publish(color);
}

turtlesim_scene::msg::Turtle Turtle::drawn() const {
  turtlesim_scene::msg::Turtle turtle;
  turtle.name = name_;
  turtle.x = static_cast<float>(x_);
  turtle.y = static_cast<float>(kFieldUnits - down_);
  turtle.theta = static_cast<float>(theta_);
  turtle.shape = shape_;
  turtle.pen = {pen_.color.r, pen_.color.g, pen_.color.b};
  turtle.pen_width = static_cast<std::uint8_t>(pen_.width);
  turtle.pen_on = pen_.is_on;
  return turtle;
}

}  // namespace turtlesim
