// MecanumDrive of Gazebo Sim: four wheels whose rollers let a robot go sideways. The rollers are
// the friction of the wheels: `mu` along `fdir1`, and a small `mu2` across it.
#include <geometry_msgs/msg/twist.hpp>

#include "plugins/gz_joints.hpp"
#include "plugins/gz_odometry.hpp"
#include "plugins/mecanum.hpp"
#include "plugins/speed_limiter.hpp"

namespace ros2wasm_sim {
namespace {

MecanumSize mecanum_size_of(const Parameters& given) {
  MecanumSize size;
  size.wheel_separation = given.number("wheel_separation", size.wheel_separation);
  size.wheel_base = given.number("wheelbase", size.wheel_base);
  size.wheel_radius = given.number("wheel_radius", size.wheel_radius);
  return size;
}

class MecanumDrive final : public System {
 public:
  explicit MecanumDrive(const PluginContext& context)
      : physics_(context.physics()),
        given_(context.plugin.xml),
        size_(mecanum_size_of(given_)),
        forward_limit_(given_, "linear"),
        left_limit_(given_, "linear"),
        turn_limit_(given_, "angular"),
        rolled_(size_),
        odometry_(context, given_) {
    front_left_ = corner(context, "front_left_joint");
    front_right_ = corner(context, "front_right_joint");
    back_left_ = corner(context, "back_left_joint");
    back_right_ = corner(context, "back_right_joint");
    const std::string topic =
        topic_of(given_, "topic", "/model/" + context.model->name + "/cmd_vel");
    subscription_ = subscribe_gz<geometry_msgs::msg::Twist>(
        context.host, topic, [this](const geometry_msgs::msg::Twist& message) {
          command_ = {message.linear.x, message.linear.y, message.angular.z};
        });
    RCLCPP_INFO(context.host.node()->get_logger(),
                "MecanumDrive subscribing to twist messages on [%s]", topic.c_str());
  }

  void before_step(const Now& now) override {
    const MecanumWheels speeds =
        mecanum_wheels(size_, {forward_limit_.limit(command_.forward, now.step),
                               left_limit_.limit(command_.left, now.step),
                               turn_limit_.limit(command_.turn, now.step)});
    drive_corner(front_left_, speeds.front_left);
    drive_corner(front_right_, speeds.front_right);
    drive_corner(back_left_, speeds.back_left);
    drive_corner(back_right_, speeds.back_right);
  }

  void after_step(const Now& now) override {
    rolled_.update({physics_.position(front_left_.front()), physics_.position(front_right_.front()),
                    physics_.position(back_left_.front()), physics_.position(back_right_.front())},
                   now.step);
    const PlanarMotion& speed = rolled_.speed;
    odometry_.publish(now, rolled_.pose(), {speed.forward, speed.left, 0}, speed.turn);
  }

  void on_reset() override {
    command_ = {};
    forward_limit_.reset();
    left_limit_.reset();
    turn_limit_.reset();
    rolled_ = MecanumOdometry(size_);
    odometry_.reset();
  }

 private:
  using Joints = std::vector<JointHandle>;

  Joints corner(const PluginContext& context, const char* element) {
    Joints joints;
    for (const std::string& name : given_.all(element)) joints.push_back(gz_joint(context, name));
    if (joints.empty())
      throw PluginError("MecanumDrive plugin of model [" + context.model->name + "] has no <" +
                        element + ">");
    return joints;
  }

  void drive_corner(const Joints& joints, double speed) {
    for (const JointHandle joint : joints)
      physics_.set_motor(joint, speed, motor_effort(physics_, joint));
  }

  Physics& physics_;
  Parameters given_;
  MecanumSize size_;
  SpeedLimiter forward_limit_, left_limit_, turn_limit_;
  MecanumOdometry rolled_;
  GzOdometry odometry_;
  Joints front_left_, front_right_, back_left_, back_right_;
  PlanarMotion command_;  ///< the last one; it stays until another one
  rclcpp::Subscription<geometry_msgs::msg::Twist>::SharedPtr subscription_;
};

}  // namespace

std::unique_ptr<System> make_mecanum_drive(const PluginContext& context) {
  return std::make_unique<MecanumDrive>(context);
}

}  // namespace ros2wasm_sim
