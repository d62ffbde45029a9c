// Drives turtle1 by keys. One thread: between keys the node is spun.
#include <cstdio>
#include <memory>
#include <optional>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_action/rclcpp_action.hpp>

#include "geometry_msgs/msg/twist.hpp"
#include "ros2wasm/keyboard.hpp"
#include "turtlesim/action/rotate_absolute.hpp"

namespace {

using Rotate = turtlesim::action::RotateAbsolute;

/// An arrow key sends ESC, `[` and one of these letters.
struct Arrow {
  char letter;
  double ahead;
  double turn;
};
constexpr Arrow kArrows[] = {{'A', 1, 0}, {'B', -1, 0}, {'C', 0, -1}, {'D', 0, 1}};

/// The letters around F show into the direction that they turn to.
struct Heading {
  char key;
  float theta;  ///< [rad]
};
constexpr Heading kHeadings[] = {{'g', 0.0F},    {'t', 0.7854F},  {'r', 1.5708F},  {'e', 2.3562F},
                                 {'d', 3.1416F}, {'c', -2.3562F}, {'v', -1.5708F}, {'b', -0.7854F}};

class TeleopTurtle {
 public:
  TeleopTurtle() : node_(std::make_shared<rclcpp::Node>("teleop_turtle")) {
    turn_scale_ = node_->declare_parameter("scale_angular", 2.0);
    ahead_scale_ = node_->declare_parameter("scale_linear", 2.0);
    commands_ = node_->create_publisher<geometry_msgs::msg::Twist>("turtle1/cmd_vel", 1);
    rotate_ = rclcpp_action::create_client<Rotate>(node_, "turtle1/rotate_absolute");
  }

  void run() {
    const ros2wasm::Keyboard keyboard;
    std::puts("Reading from keyboard");
    std::puts("---------------------------");
    std::puts("Use arrow keys to move the turtle.");
    std::puts(
        "Use G|B|V|C|D|E|R|T keys to rotate to absolute orientations. 'F' to cancel a rotation.");
    std::puts("'Q' to quit.");
    std::fflush(stdout);
    while (rclcpp::ok()) {
      rclcpp::spin_some(node_);
      if (!ros2wasm::Keyboard::has_something()) continue;
      const auto key = ros2wasm::Keyboard::key();
      if (!key || *key == 'q') return;
      press(*key);
    }
  }

 private:
  void press(char key) {
    for (const Arrow& arrow : kArrows) {
      if (arrow.letter == key) drive(arrow);
    }
    for (const Heading& heading : kHeadings) {
      if (heading.key == key) turn_to(heading.theta);
    }
    if (key == 'f' && goal_) rotate_->async_cancel_goal(goal_);
  }

  void drive(const Arrow& arrow) {
    geometry_msgs::msg::Twist twist;
    twist.linear.x = ahead_scale_ * arrow.ahead;
    twist.angular.z = turn_scale_ * arrow.turn;
    commands_->publish(twist);
  }

  void turn_to(float theta) {
    Rotate::Goal goal;
    goal.theta = theta;
    rclcpp_action::Client<Rotate>::SendGoalOptions options;
    options.goal_response_callback = [this](const GoalHandle& handle) { goal_ = handle; };
    // A goal that is over cannot be cancelled.
    options.result_callback =
        [this](const rclcpp_action::ClientGoalHandle<Rotate>::WrappedResult& result) {
          if (goal_ && goal_->get_goal_id() == result.goal_id) goal_.reset();
        };
    rotate_->async_send_goal(goal, options);
  }

  using GoalHandle = rclcpp_action::ClientGoalHandle<Rotate>::SharedPtr;

  rclcpp::Node::SharedPtr node_;
  double ahead_scale_ = 0;
  double turn_scale_ = 0;
  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr commands_;
  rclcpp_action::Client<Rotate>::SharedPtr rotate_;
  GoalHandle goal_;
};

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  TeleopTurtle().run();
  rclcpp::shutdown();
  return 0;
}
