// libgazebo_ros_diff_drive.so: two or more driven wheels, and odometry.
#include <geometry_msgs/msg/transform_stamped.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <tf2_ros/transform_broadcaster.hpp>

#include <algorithm>
#include <cmath>

#include "plugins/classic_odometry.hpp"
#include "plugins/wheel_watch.hpp"

namespace ros2wasm_sim {
namespace {

/// The two wheels of a pair.
struct WheelPair {
  JointHandle left, right;
  std::string left_link, right_link;
  double separation = 0.34;                ///< metres
  double diameter = 0.15;                  ///< metres
  double left_speed = 0, right_speed = 0;  ///< that was commanded, rad/s
};

class ClassicDiffDrive final : public System {
 public:
  explicit ClassicDiffDrive(const PluginContext& context)
      : simulation_(context.simulation),
        node_(context.host, context.plugin),
        model_(context.model->name),
        odometry_(Parameters(context.plugin.xml)),
        rate_(Parameters(context.plugin.xml).number("update_rate", 100)) {
    const Parameters given(context.plugin.xml);
    read_wheels(context, given);
    max_torque_ = given.number("max_wheel_torque", 5);
    max_acceleration_ = given.number("max_wheel_acceleration", 0);
    from_world_ = given.number("odometry_source", 1) != 0;
    publishes_odometry_ = given.flag("publish_odom", false);
    publishes_odometry_frame_ = given.flag("publish_odom_tf", false);
    publishes_wheel_frames_ = given.flag("publish_wheel_tf", false);
    connect();
  }

  void before_step(const Now& now) override {
    if (rate_.due(now.time_ns)) {
      if (from_world_) update_from_world();
      publish(now);
      command_wheels(now);  // the motors keep it between the updates
    }
  }

  void after_step(const Now& now) override {
    wheels_->look(now);
    if (!from_world_) update_from_encoders(now);
  }

  void on_reset() override {
    rate_.reset();
    last_ns_ = -1;
    pose_ = {};
    for (WheelPair& pair : pairs_) pair.left_speed = pair.right_speed = 0;
    forward_ = turn_ = 0;
  }

 private:
  void read_wheels(const PluginContext& context, const Parameters& given) {
    const auto pairs =
        static_cast<std::size_t>(std::clamp(given.number("num_wheel_pairs", 1), 1.0, 50.0));
    const auto left = given.all("left_joint"), right = given.all("right_joint");
    if (left.size() < pairs || right.size() < pairs)
      throw PluginError("Inconsistent number of joints specified. Plugin will not work.");
    const auto separations = given.all("wheel_separation"), diameters = given.all("wheel_diameter");
    DrivenWheels wheels;
    wheels.writes_diameter = true;
    for (std::size_t i = 0; i < pairs; ++i) {
      WheelPair pair;
      pair.left = joint_of(context, left[i]);
      pair.right = joint_of(context, right[i]);
      pair.left_link = child_of(*context.model, context.plugin.model_scope + left[i]);
      pair.right_link = child_of(*context.model, context.plugin.model_scope + right[i]);
      if (i < separations.size())
        pair.separation = given.each("wheel_separation")[i].own_number(0.34);
      if (i < diameters.size()) pair.diameter = given.each("wheel_diameter")[i].own_number(0.15);
      RCLCPP_INFO(node_->get_logger(), "Wheel pair %zu separation set to [%fm]", i + 1,
                  pair.separation);
      RCLCPP_INFO(node_->get_logger(), "Wheel pair %zu diameter set to [%fm]", i + 1,
                  pair.diameter);
      pairs_.push_back(pair);
      wheels.left.push_back(context.plugin.model_scope + left[i]);
      wheels.right.push_back(context.plugin.model_scope + right[i]);
    }
    wheels.separation = pairs_.front().separation;
    wheels.radius = pairs_.front().diameter / 2;
    wheels_.emplace(context, wheels);
  }

  void connect() {
    subscription_ = node_->create_subscription<geometry_msgs::msg::Twist>(
        "cmd_vel", rclcpp::QoS(1), [this](const geometry_msgs::msg::Twist& command) {
          forward_ = command.linear.x;
          turn_ = command.angular.z;
        });
    RCLCPP_INFO(node_->get_logger(), "Subscribed to [%s]", subscription_->get_topic_name());
    if (publishes_odometry_) {
      publisher_ = node_->create_publisher<nav_msgs::msg::Odometry>("odom", rclcpp::QoS(1));
      RCLCPP_INFO(node_->get_logger(), "Advertise odometry on [%s]", publisher_->get_topic_name());
    }
    if (publishes_odometry_frame_ || publishes_wheel_frames_)
      frames_ = std::make_unique<tf2_ros::TransformBroadcaster>(node_.get());
    if (publishes_odometry_frame_)
      RCLCPP_INFO(node_->get_logger(), "Publishing odom transforms between [%s] and [%s]",
                  odometry_.frame().c_str(), odometry_.base().c_str());
    if (!publishes_wheel_frames_) return;
    for (const WheelPair& pair : pairs_)
      for (const std::string& link : {pair.left_link, pair.right_link})
        RCLCPP_INFO(node_->get_logger(), "Publishing wheel transforms between [%s] and [%s]",
                    odometry_.base().c_str(), link.c_str());
  }

  void command_wheels(const Now& now) {
    // Nothing has passed before the first update, however late the robot was spawned.
    const double seconds = last_ns_ < 0 ? 0 : static_cast<double>(now.time_ns - last_ns_) * 1e-9;
    last_ns_ = now.time_ns;
    for (WheelPair& pair : pairs_) {
      const double radius = pair.diameter / 2;
      const double left = (forward_ - turn_ * pair.separation / 2) / radius;
      const double right = (forward_ + turn_ * pair.separation / 2) / radius;
      approach(pair, left, right, radius, seconds);
      physics().set_motor(pair.left, pair.left_speed, max_torque_);
      physics().set_motor(pair.right, pair.right_speed, max_torque_);
    }
  }

  /// With a limit of acceleration (m/s^2 at the rim), once a wheel is off by 0.01 m/s or more.
  void approach(WheelPair& pair, double left, double right, double radius, double seconds) {
    const double left_now = physics().velocity(pair.left),
                 right_now = physics().velocity(pair.right);
    const bool is_near =
        std::abs(left - left_now) * radius < 0.01 && std::abs(right - right_now) * radius < 0.01;
    if (max_acceleration_ <= 0 || is_near) {
      pair.left_speed = left;
      pair.right_speed = right;
      return;
    }
    const double most = max_acceleration_ * seconds / radius;
    pair.left_speed += std::clamp(left - left_now, -most, most);
    pair.right_speed += std::clamp(right - right_now, -most, most);
  }

  /// The pose in the world, spawn pose included, as upstream has it.
  void update_from_world() {
    const Model* model = simulation_.model(model_);
    if (model == nullptr) return;
    pose_ = simulation_.model_pose(*model);
    motion_ = level_motion(simulation_, *model, pose_);
  }

  void update_from_encoders(const Now& now) {
    const WheelPair& pair = pairs_.front();
    const double left = physics().velocity(pair.left) * pair.diameter / 2 * now.step;
    const double right = physics().velocity(pair.right) * pair.diameter / 2 * now.step;
    const double forward = (left + right) / 2, turned = (right - left) / pair.separation;
    const double yaw = yaw_of(pose_.orientation), middle = yaw + turned / 2;
    pose_.position.x += forward * std::cos(middle);
    pose_.position.y += forward * std::sin(middle);
    pose_.orientation = from_roll_pitch_yaw(0, 0, yaw + turned);
    motion_ = {{std::abs(forward) / now.step, 0, 0}, turned / now.step};
  }

  void publish(const Now& now) {
    const auto stamp = stamp_of(now.time_ns);
    if (publishes_odometry_) {
      nav_msgs::msg::Odometry message = odometry_.message(stamp, pose_, motion_);
      message.twist.covariance = message.pose.covariance;
      publisher_->publish(message);
    }
    if (publishes_odometry_frame_)
      frames_->sendTransform(transform_message(stamp, odometry_.frame(), odometry_.base(), pose_));
    if (publishes_wheel_frames_) publish_wheels(stamp);
  }

  void publish_wheels(const builtin_interfaces::msg::Time& stamp) {
    const Model* model = simulation_.model(model_);
    if (model == nullptr) return;
    const Pose base = inverse(simulation_.model_pose(*model));
    for (const WheelPair& pair : pairs_)
      for (const std::string& link : {pair.left_link, pair.right_link})
        frames_->sendTransform(transform_message(
            stamp, odometry_.base(), link, base * physics().pose(physics().link(model_, link))));
  }

  Physics& physics() { return simulation_.physics(); }

  Simulation& simulation_;
  PluginNode node_;
  std::string model_;
  ClassicOdometry odometry_;
  Rate rate_;
  std::int64_t last_ns_ = -1;  ///< of the last update; -1: there was none
  std::vector<WheelPair> pairs_;
  std::optional<WheelWatch> wheels_;
  double max_torque_ = 5;        ///< N m
  double max_acceleration_ = 0;  ///< m/s^2; 0: no limit
  bool from_world_ = true;
  bool publishes_odometry_ = false, publishes_odometry_frame_ = false,
       publishes_wheel_frames_ = false;
  double forward_ = 0, turn_ = 0;  ///< the last command, m/s and rad/s; it stays until another one
  Pose pose_;
  LevelMotion motion_;
  rclcpp::Subscription<geometry_msgs::msg::Twist>::SharedPtr subscription_;
  rclcpp::Publisher<nav_msgs::msg::Odometry>::SharedPtr publisher_;
  std::unique_ptr<tf2_ros::TransformBroadcaster> frames_;
};

}  // namespace

std::unique_ptr<System> make_classic_diff_drive(const PluginContext& context) {
  return std::make_unique<ClassicDiffDrive>(context);
}

}  // namespace ros2wasm_sim
