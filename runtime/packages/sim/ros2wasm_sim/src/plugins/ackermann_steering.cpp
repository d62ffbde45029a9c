// AckermannSteering of Gazebo Sim: a car whose front wheels steer and whose rear wheels drive.
#include <geometry_msgs/msg/twist.hpp>
#include <std_msgs/msg/float64.hpp>

#include "plugins/ackermann.hpp"
#include "plugins/gz_joints.hpp"
#include "plugins/gz_odometry.hpp"
#include "plugins/speed_limiter.hpp"

namespace ros2wasm_sim {
namespace {

CarSize car_size_of(const Parameters& given) {
  CarSize size;
  size.wheel_separation = given.number("wheel_separation", size.wheel_separation);
  size.kingpin_width = given.number("kingpin_width", size.kingpin_width);
  size.wheel_base = given.number("wheel_base", size.wheel_base);
  size.wheel_radius = given.number("wheel_radius", size.wheel_radius);
  size.steering_limit = given.number("steering_limit", size.steering_limit);
  return size;
}

class AckermannSteering final : public System {
 public:
  explicit AckermannSteering(const PluginContext& context)
      : physics_(context.physics()),
        given_(context.plugin.xml),
        size_(car_size_of(given_)),
        gain_(given_.number("steer_p_gain", 1)),
        steers_only_(given_.flag("steering_only", false)),
        forward_limit_(given_, "linear"),
        turn_limit_(given_, "angular"),
        rolled_(size_),
        odometry_(context, given_) {
    left_steering_ = side(context, "left_steering_joint");
    right_steering_ = side(context, "right_steering_joint");
    const std::string prefix = "/model/" + context.model->name;
    if (steers_only_) {
      angle_subscription_ = subscribe_gz<std_msgs::msg::Float64>(
          context.host, command_topic(context, given_, prefix + "/steer_angle"),
          [this](const std_msgs::msg::Float64& message) {
            angle_ = std::clamp(message.data, -size_.steering_limit, size_.steering_limit);
          });
      return;
    }
    left_ = side(context, "left_joint");
    right_ = side(context, "right_joint");
    const std::string topic = command_topic(context, given_, prefix + "/cmd_vel");
    subscription_ = subscribe_gz<geometry_msgs::msg::Twist>(
        context.host, topic, [this](const geometry_msgs::msg::Twist& message) {
          forward_ = message.linear.x;
          turn_ = message.angular.z;
        });
    RCLCPP_INFO(context.host.node()->get_logger(),
                "AckermannSteering subscribing to twist messages on [%s]", topic.c_str());
  }

  void before_step(const Now& now) override {
    if (steers_only_) {
      const double radius = std::abs(angle_) < 1e-6 ? 1e9 : size_.wheel_base / std::tan(angle_);
      steer(steering_at(size_, radius));
      return;
    }
    const CarCommand command = car_command(size_, forward_limit_.limit(forward_, now.step),
                                           turn_limit_.limit(turn_, now.step));
    drive(left_, command.left_speed);
    drive(right_, command.right_speed);
    steer(command.steering);
  }

  void after_step(const Now& now) override {
    if (steers_only_) return;
    rolled_.update(
        physics_.position(left_.front()), physics_.position(right_.front()),
        {physics_.position(left_steering_.front()), physics_.position(right_steering_.front())},
        now.step);
    odometry_.publish(now, rolled_.pose(), {rolled_.forward_speed, 0, 0}, rolled_.turn_speed);
  }

  void on_reset() override {
    forward_ = turn_ = angle_ = 0;
    forward_limit_.reset();
    turn_limit_.reset();
    rolled_ = CarOdometry(size_);
    odometry_.reset();
  }

 private:
  using Joints = std::vector<JointHandle>;

  Joints side(const PluginContext& context, const char* element) {
    Joints joints;
    for (const std::string& name : given_.all(element)) joints.push_back(gz_joint(context, name));
    if (joints.empty())
      throw PluginError("AckermannSteering plugin of model [" + context.model->name + "] has no <" +
                        element + ">");
    return joints;
  }

  void drive(const Joints& joints, double speed) {
    for (const JointHandle joint : joints)
      physics_.set_motor(joint, speed, motor_effort(physics_, joint));
  }

  void steer(const SteeringAngles& angles) {
    drive(left_steering_, gain_ * (angles.left - physics_.position(left_steering_.front())));
    drive(right_steering_, gain_ * (angles.right - physics_.position(right_steering_.front())));
  }

  Physics& physics_;
  Parameters given_;
  CarSize size_;
  double gain_;  ///< of the steering, 1/s
  bool steers_only_;
  SpeedLimiter forward_limit_, turn_limit_;
  CarOdometry rolled_;
  GzOdometry odometry_;
  Joints left_, right_, left_steering_, right_steering_;
  double forward_ = 0, turn_ = 0;  ///< the last command, m/s and rad/s
  double angle_ = 0;               ///< the last command when it steers only
  rclcpp::Subscription<geometry_msgs::msg::Twist>::SharedPtr subscription_;
  rclcpp::Subscription<std_msgs::msg::Float64>::SharedPtr angle_subscription_;
};

}  // namespace

std::unique_ptr<System> make_ackermann_steering(const PluginContext& context) {
  return std::make_unique<AckermannSteering>(context);
}

}  // namespace ros2wasm_sim
