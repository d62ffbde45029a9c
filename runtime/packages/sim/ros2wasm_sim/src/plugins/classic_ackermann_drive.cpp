// libgazebo_ros_ackermann_drive.so: a car whose wheels are driven and steered by forces.
#include <geometry_msgs/msg/twist.hpp>
#include <std_msgs/msg/float32.hpp>
#include <tf2_ros/transform_broadcaster.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "plugins/ackermann.hpp"
#include "plugins/classic_odometry.hpp"
#include "plugins/pid.hpp"

namespace ros2wasm_sim {
namespace {

/// `<NAME_pid_gain>` has p, i and d, `<NAME_i_range>` the largest and the least integral.
Pid car_pid(const Parameters& given, const std::string& name) {
  const Vector3 gains = given.vector(name + "_pid_gain");
  const Vector3 range = given.vector(name + "_i_range");
  PidSettings settings;
  settings.p = gains.x;
  settings.i = gains.y;
  settings.d = gains.z;
  settings.i_max = range.x;
  settings.i_min = range.y;
  return Pid(settings);
}

class ClassicAckermannDrive final : public System {
 public:
  explicit ClassicAckermannDrive(const PluginContext& context)
      : simulation_(context.simulation),
        node_(context.host, context.plugin),
        model_(context.model->name),
        described_(Parameters(context.plugin.xml)),
        rate_(Parameters(context.plugin.xml).number("update_rate", 100)) {
    const Parameters given(context.plugin.xml);
    for (const char* name : {"front_left_joint", "front_right_joint", "rear_left_joint",
                             "rear_right_joint", "left_steering_joint", "right_steering_joint"})
      joints_.push_back(joint_of(context, given.text(name, name)));
    if (given.has("steering_wheel_joint"))
      steering_wheel_ = joint_of(context, given.text("steering_wheel_joint", ""));
    measure(context, given);
    max_speed_ = given.number("max_speed", 20);
    max_steer_ = given.number("max_steer", 0.6);
    steering_ratio_ = max_steer_ / given.number("max_steering_angle", 7.85);
    left_pid_ = car_pid(given, "left_steering");
    right_pid_ = car_pid(given, "right_steering");
    speed_pid_ = car_pid(given, "linear_velocity");
    connect(given);
  }

  void before_step(const Now& now) override {
    if (!rate_.due(now.time_ns)) return;
    const double seconds = last_ns_ < 0 ? 0 : static_cast<double>(now.time_ns - last_ns_) * 1e-9;
    last_ns_ = now.time_ns;
    publish_car(now);
    // As with upstream, a force lasts one step.
    const double speed = std::clamp(forward_, -max_speed_, max_speed_) / wheel_radius_;
    const double force =
        speed_pid_.update(physics().velocity(joints_[kRearRight]) - speed, seconds);
    physics().add_effort(joints_[kRearLeft], force);
    physics().add_effort(joints_[kRearRight], force);
    const double angle = std::clamp(angle_ * std::copysign(1.0, forward_), -max_steer_, max_steer_);
    const SteeringAngles wanted = steering_of_middle(angle, separation_, wheel_base_);
    const double left = physics().position(joints_[kSteerLeft]);
    const double right = physics().position(joints_[kSteerRight]);
    physics().add_effort(joints_[kSteerLeft], left_pid_.update(left - wanted.left, seconds));
    physics().add_effort(joints_[kSteerRight], right_pid_.update(right - wanted.right, seconds));
    if (steering_wheel_.valid())
      physics().set_position(steering_wheel_, (left + right) / 2 / steering_ratio_);
  }

  void on_reset() override {
    rate_.reset();
    last_ns_ = -1;
    forward_ = angle_ = distance_ = 0;
    is_placed_ = false;
    for (Pid* pid : {&left_pid_, &right_pid_, &speed_pid_}) pid->reset();
  }

 private:
  enum Wheel { kFrontLeft, kFrontRight, kRearLeft, kRearRight, kSteerLeft, kSteerRight };

  /// The size of the car, from the first shape of each wheel.
  void measure(const PluginContext& context, const Parameters& given) {
    Vector3 centres[4];
    const char* const names[] = {"front_left_joint", "front_right_joint", "rear_left_joint",
                                 "rear_right_joint"};
    for (int i = 0; i < 4; ++i) {
      const std::string link_name =
          child_of(*context.model, context.plugin.model_scope + given.text(names[i], names[i]));
      wheel_links_.push_back(link_name);
      for (const Link& link : context.model->links) {
        if (link.name != link_name || link.collisions.empty()) continue;
        const Collision& shape = link.collisions.front();
        centres[i] = (link.pose * shape.pose).position;
        if (i != kRearRight) continue;
        if (const auto* one = std::get_if<Cylinder>(&shape.geometry)) wheel_radius_ = one->radius;
        if (const auto* one = std::get_if<Sphere>(&shape.geometry)) wheel_radius_ = one->radius;
      }
    }
    separation_ = length(centres[kFrontLeft] - centres[kFrontRight]);
    wheel_base_ = length(0.5 * (centres[kFrontLeft] + centres[kFrontRight]) -
                         0.5 * (centres[kRearLeft] + centres[kRearRight]));
    if (wheel_radius_ <= 0 || wheel_base_ <= 0)
      throw PluginError(
          "the wheels need collisions that are cylinders or spheres, the front ones before the "
          "rear ones; plugin will not work");
  }

  void connect(const Parameters& given) {
    subscription_ = node_->create_subscription<geometry_msgs::msg::Twist>(
        "cmd_vel", rclcpp::QoS(1), [this](const geometry_msgs::msg::Twist& command) {
          forward_ = command.linear.x;
          angle_ = command.angular.z;
        });
    RCLCPP_INFO(node_->get_logger(), "Subscribed to [%s]", subscription_->get_topic_name());
    if (given.flag("publish_odom", false)) {
      odometry_ = node_->create_publisher<nav_msgs::msg::Odometry>("odom", rclcpp::QoS(1));
      RCLCPP_INFO(node_->get_logger(), "Advertise odometry on [%s]", odometry_->get_topic_name());
    }
    if (given.flag("publish_distance", false)) {
      way_ = node_->create_publisher<std_msgs::msg::Float32>("distance", rclcpp::QoS(1));
      RCLCPP_INFO(node_->get_logger(), "Advertise distance on [%s]", way_->get_topic_name());
    }
    if (given.flag("publish_steerangle", false)) {
      steering_ = node_->create_publisher<std_msgs::msg::Float32>("steerangle", rclcpp::QoS(1));
      RCLCPP_INFO(node_->get_logger(), "Advertise steer angle on [%s]",
                  steering_->get_topic_name());
    }
    publishes_frame_ = given.flag("publish_odom_tf", false);
    publishes_wheels_ = given.flag("publish_wheel_tf", false);
    if (publishes_frame_ || publishes_wheels_)
      frames_ = std::make_unique<tf2_ros::TransformBroadcaster>(node_.get());
    if (publishes_frame_)
      RCLCPP_INFO(node_->get_logger(), "Publishing odom transforms between [%s] and [%s]",
                  described_.frame().c_str(), described_.base().c_str());
  }

  void publish_car(const Now& now) {
    const Model* model = simulation_.model(model_);
    if (model == nullptr) return;
    const Pose pose = simulation_.model_pose(*model);
    const auto stamp = stamp_of(now.time_ns);
    if (is_placed_) {
      const Vector3 moved = pose.position - last_position_;
      distance_ += std::hypot(moved.x, moved.y);
    }
    is_placed_ = true;
    last_position_ = pose.position;
    if (odometry_ != nullptr) publish_odometry(*model, pose, stamp);
    if (way_ != nullptr) {
      std_msgs::msg::Float32 message;
      message.data = static_cast<float>(distance_);
      way_->publish(message);
    }
    if (steering_ != nullptr) {
      std_msgs::msg::Float32 message;
      message.data = static_cast<float>(
          (physics().position(joints_[kSteerLeft]) + physics().position(joints_[kSteerRight])) / 2);
      steering_->publish(message);
    }
    if (publishes_frame_)
      frames_->sendTransform(transform_message(stamp, described_.frame(), described_.base(), pose));
    if (!publishes_wheels_) return;
    for (const std::string& link : wheel_links_)
      frames_->sendTransform(
          transform_message(stamp, described_.base(), link,
                            inverse(pose) * physics().pose(physics().link(model_, link))));
  }

  void publish_odometry(const Model& model, const Pose& pose,
                        const builtin_interfaces::msg::Time& stamp) {
    nav_msgs::msg::Odometry message =
        described_.message(stamp, pose, level_motion(simulation_, model, pose));
    message.twist.covariance = message.pose.covariance;
    odometry_->publish(message);
  }

  Physics& physics() { return simulation_.physics(); }

  Simulation& simulation_;
  PluginNode node_;
  std::string model_;
  ClassicOdometry described_;
  Rate rate_;
  std::int64_t last_ns_ = -1;  ///< of the last update; -1: there was none
  std::vector<JointHandle> joints_;
  std::vector<std::string> wheel_links_;
  JointHandle steering_wheel_;  ///< that a driver would turn; not valid when there is none
  double wheel_radius_ = 0, separation_ = 0, wheel_base_ = 0;  ///< metres
  double max_speed_ = 20, max_steer_ = 0.6;                    ///< m/s and rad
  double steering_ratio_ = 1;
  Pid left_pid_, right_pid_, speed_pid_;
  double forward_ = 0, angle_ = 0;  ///< the last command: m/s and the steering angle in rad
  Vector3 last_position_;
  bool is_placed_ = false;
  double distance_ = 0;  ///< metres
  bool publishes_frame_ = false, publishes_wheels_ = false;
  rclcpp::Subscription<geometry_msgs::msg::Twist>::SharedPtr subscription_;
  rclcpp::Publisher<nav_msgs::msg::Odometry>::SharedPtr odometry_;
  rclcpp::Publisher<std_msgs::msg::Float32>::SharedPtr way_, steering_;
  std::unique_ptr<tf2_ros::TransformBroadcaster> frames_;
};

}  // namespace

std::unique_ptr<System> make_classic_ackermann_drive(const PluginContext& context) {
  return std::make_unique<ClassicAckermannDrive>(context);
}

}  // namespace ros2wasm_sim
