// Has turtle1 draw squares: two units ahead, a quarter turn to the left, and so on.
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <rclcpp/rclcpp.hpp>

#include "geometry_msgs/msg/twist.hpp"
#include "std_srvs/srv/empty.hpp"
#include "turtlesim/msg/pose.hpp"

namespace {

using geometry_msgs::msg::Twist;
using turtlesim::msg::Pose;

constexpr double kSide = 2.0;        // [units]
constexpr double kAheadSpeed = 1.0;  // [units/s]
constexpr double kTurnSpeed = 0.4;   // [rad/s]
constexpr float kPi = 3.141592F;

class DrawSquare : public rclcpp::Node {
 public:
  DrawSquare() : Node("draw_square") {
    commands_ = create_publisher<Twist>("turtle1/cmd_vel", 1);
    poses_ =
        create_subscription<Pose>("turtle1/pose", 1, [this](const Pose& pose) { pose_ = pose; });
    reset_ = create_client<std_srvs::srv::Empty>("reset");
    timer_ = create_wall_timer(std::chrono::milliseconds(16), [this] { tick(); });
  }

 private:
  enum class Phase { kAhead, kStopAhead, kTurn, kStopTurn };

  /// Begins on a fresh sheet: poses count only from when the simulator has been reset.
  bool is_reset() {
    if (!reset_sent_ && reset_->service_is_ready()) {
      reset_sent_ = true;
      reset_->async_send_request(std::make_shared<std_srvs::srv::Empty::Request>(),
                                 [this](const auto&) {
                                   pose_.reset();
                                   reset_done_ = true;
                                 });
    }
    return reset_done_;
  }

  void tick() {
    if (!is_reset() || !pose_) return;
    if (!goal_) begin_side();
    switch (phase_) {
      case Phase::kAhead:
        drive(Phase::kStopAhead, kAheadSpeed, 0);
        return;
      case Phase::kStopAhead:
        if (is_stopped()) begin_turn();
        return;
      case Phase::kTurn:
        drive(Phase::kStopTurn, 0, kTurnSpeed);
        return;
      case Phase::kStopTurn:
        if (is_stopped()) begin_side();
        return;
    }
  }

  void drive(Phase next, double ahead, double turn) {
    if (!is_near_goal()) return command(ahead, turn);
    phase_ = next;
    command(0, 0);
  }

  bool is_near_goal() const {
    return std::abs(pose_->x - goal_->x) < 0.1F && std::abs(pose_->y - goal_->y) < 0.1F &&
           std::abs(pose_->theta - goal_->theta) < 0.01F;
  }

  bool is_stopped() {
    if (pose_->linear_velocity < 0.0001F && pose_->angular_velocity < 0.0001F) {
      RCLCPP_INFO(get_logger(), "Reached goal");
      return true;
    }
    command(0, 0);
    return false;
  }

  void begin_side() {
    Pose goal = *pose_;
    goal.x += static_cast<float>(std::cos(pose_->theta) * kSide);
    goal.y += static_cast<float>(std::sin(pose_->theta) * kSide);
    begin(Phase::kAhead, goal);
  }

  void begin_turn() {
    Pose goal = *pose_;
    goal.theta = std::fmod(pose_->theta + kPi / 2, 2 * kPi);
    if (goal.theta >= kPi) goal.theta -= 2 * kPi;
    begin(Phase::kTurn, goal);
  }

  void begin(Phase phase, const Pose& goal) {
    phase_ = phase;
    goal_ = goal;
    RCLCPP_INFO(get_logger(), "New goal [%f %f, %f]", goal.x, goal.y, goal.theta);
  }

  void command(double ahead, double turn) {
    Twist twist;
    twist.linear.x = ahead;
    twist.angular.z = turn;
    commands_->publish(twist);
  }

  rclcpp::Publisher<Twist>::SharedPtr commands_;
  rclcpp::Subscription<Pose>::SharedPtr poses_;
  rclcpp::Client<std_srvs::srv::Empty>::SharedPtr reset_;
  rclcpp::TimerBase::SharedPtr timer_;
  bool reset_sent_ = false;
  bool reset_done_ = false;
  std::optional<Pose> pose_;
  std::optional<Pose> goal_;
  Phase phase_ = Phase::kAhead;
};

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<DrawSquare>());
  rclcpp::shutdown();
  return 0;
}
