// Moves the arm: each joint goes at its own pace to where its parameter says. Until somebody sets
// one, the arm waves, or this node says nothing if it is not to wave. A goal pose turns the arm to
// that side.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "geometry_msgs/msg/pose_stamped.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/joint_state.hpp"

namespace {

/// Radians, metres for the finger; the same limits as in the robot's description.
struct Joint {
  const char* parameter;
  const char* joint;
  double least;
  double most;
  double speed;  ///< per second
  double wave;   ///< how far it goes to either side when the arm waves
};

constexpr std::array kJoints{
    Joint{"turn", "turn", -3.1, 3.1, 1.5, 1.2},
    Joint{"shoulder", "shoulder", -1.6, 1.6, 1.0, 0.5},
    Joint{"elbow", "elbow", -2.4, 2.4, 1.2, 0.9},
    Joint{"gripper", "left_finger_joint", 0.0, 0.05, 0.05, 0.05},
};
constexpr double kPeriod = 0.04;  // seconds

class Mover : public rclcpp::Node {
public:
  Mover() : Node("mover") {
    waving_ = declare_parameter("wave", true);
    for (const Joint& joint : kJoints) {
      rcl_interfaces::msg::ParameterDescriptor descriptor;
      descriptor.description = std::string("where the joint ") + joint.joint + " goes";
      descriptor.floating_point_range.resize(1);
      descriptor.floating_point_range[0].from_value = joint.least;
      descriptor.floating_point_range[0].to_value = joint.most;
      declare_parameter(joint.parameter, 0.0, descriptor);
    }
    publisher_ = create_publisher<sensor_msgs::msg::JointState>("joint_states", 10);
    goal_ = create_subscription<geometry_msgs::msg::PoseStamped>(
        "/goal_pose", 10, [this](const geometry_msgs::msg::PoseStamped& goal) { face(goal); });
    handle_ = add_post_set_parameters_callback(
        [this](const std::vector<rclcpp::Parameter>& parameters) { take(parameters); });
    timer_ = rclcpp::create_timer(this, get_clock(), rclcpp::Duration::from_seconds(kPeriod),
                                  [this] { step(); });
    RCLCPP_INFO(get_logger(), waving_ ? "waving" : "waiting for a joint to be set");
  }

private:
  void take(const std::vector<rclcpp::Parameter>& parameters) {
    for (const rclcpp::Parameter& parameter : parameters) {
      if (parameter.get_name() == "wave") {
        waving_ = parameter.as_bool();
        continue;
      }
      for (std::size_t i = 0; i < kJoints.size(); ++i) {
        if (parameter.get_name() == kJoints[i].parameter) {
          waving_ = false;
          asked_ = true;
          goals_[i] = parameter.as_double();
          RCLCPP_INFO(get_logger(), "%s goes to %.2f", kJoints[i].parameter, goals_[i]);
        }
      }
    }
  }

  void face(const geometry_msgs::msg::PoseStamped& goal) {
    const double angle = std::atan2(goal.pose.position.y, goal.pose.position.x);
    set_parameter({"turn", std::clamp(angle, kJoints[0].least, kJoints[0].most)});
  }

  void step() {
    // Somebody else may move the joints.
    if (!waving_ && !asked_) return;
    time_ += kPeriod;
    sensor_msgs::msg::JointState state;
    state.header.stamp = now();
    for (std::size_t i = 0; i < kJoints.size(); ++i) {
      const Joint& joint = kJoints[i];
      // Each at another rhythm, so that the arm does not look like a machine.
      const double wave = joint.wave * std::sin(time_ * (0.5 + 0.2 * static_cast<double>(i)));
      const double wanted = waving_ ? std::clamp(wave, joint.least, joint.most) : goals_[i];
      const double reach = joint.speed * kPeriod;
      positions_[i] += std::clamp(wanted - positions_[i], -reach, reach);
      state.name.emplace_back(joint.joint);
      state.position.push_back(positions_[i]);
    }
    publisher_->publish(state);
  }

  bool waving_ = true;
  bool asked_ = false;  ///< somebody has set a joint
  double time_ = 0;
  std::array<double, kJoints.size()> positions_{};
  std::array<double, kJoints.size()> goals_{};
  rclcpp::Publisher<sensor_msgs::msg::JointState>::SharedPtr publisher_;
  rclcpp::Subscription<geometry_msgs::msg::PoseStamped>::SharedPtr goal_;
  PostSetParametersCallbackHandle::SharedPtr handle_;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Mover>());
  rclcpp::shutdown();
  return 0;
}
