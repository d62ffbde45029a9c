// DiffDrive of Gazebo Sim: wheels on two sides, and odometry from their angles.
#include <nav_msgs/msg/odometry.hpp>
#include <std_msgs/msg/bool.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "geometry_msgs/msg/twist.hpp"
#include "plugins/diff_drive_odometry.hpp"
#include "plugins/gz_topics.hpp"
#include "plugins/messages.hpp"
#include "plugins/speed_limiter.hpp"
#include "plugins/wheel_watch.hpp"

namespace ros2wasm_sim {
namespace {

class DiffDrive final : public System {
 public:
  explicit DiffDrive(const PluginContext& context)
      : physics_(context.physics()),
        given_(context.plugin.xml),
        separation_(given_.number("wheel_separation", 1.0)),
        radius_(given_.number("wheel_radius", 0.2)),
        forward_limit_(given_, "linear"),
        turn_limit_(given_, "angular"),
        odometry_(separation_, radius_),
        rate_(given_.number("odom_publish_frequency", 50)) {
    const std::string& model = context.model->name;
    read_side(context, "left_joint", left_);
    read_side(context, "right_joint", right_);
    const std::string canonical = context.model->canonical_link.empty()
                                      ? context.model->links.front().name
                                      : context.model->canonical_link;
    frame_ = given_.text("frame_id", model + "/odom");
    child_frame_ = given_.text("child_frame_id", model + "/" + canonical);
    connect(context, "/model/" + model);
    DrivenWheels wheels{{}, {}, separation_, radius_};
    for (const std::string& name : given_.all("left_joint"))
      wheels.left.push_back(context.plugin.model_scope + name);
    for (const std::string& name : given_.all("right_joint"))
      wheels.right.push_back(context.plugin.model_scope + name);
    wheels_.emplace(context, wheels);
  }

  void before_step(const Now& now) override {
    const double forward = forward_limit_.limit(enabled_ ? forward_ : 0, now.step);
    const double turn = turn_limit_.limit(enabled_ ? turn_ : 0, now.step);
    for (const Wheel& wheel : left_)
      physics_.set_motor(wheel.joint, (forward - turn * separation_ / 2) / radius_,
                         wheel.max_effort);
    for (const Wheel& wheel : right_)
      physics_.set_motor(wheel.joint, (forward + turn * separation_ / 2) / radius_,
                         wheel.max_effort);
  }

  void after_step(const Now& now) override {
    wheels_->look(now);
    odometry_.update(physics_.position(left_.front().joint),
                     physics_.position(right_.front().joint), now.step);
    if (!rate_.due(now.time_ns)) return;
    const auto stamp = stamp_of(now.time_ns);
    nav_msgs::msg::Odometry message;
    message.header.stamp = stamp;
    message.header.frame_id = frame_;
    message.child_frame_id = child_frame_;
    message.pose.pose = pose_message(odometry_.pose());
    message.twist.twist.linear.x = odometry_.forward_speed();
    message.twist.twist.angular.z = odometry_.turn_speed();
    odometry_publisher_->publish(message);
    tf2_msgs::msg::TFMessage frames;
    frames.transforms.push_back(transform_message(stamp, frame_, child_frame_, odometry_.pose()));
    frame_publisher_->publish(frames);
  }

  void on_reset() override {
    rate_.reset();
    forward_limit_.reset();
    turn_limit_.reset();
    forward_ = turn_ = 0;
    odometry_ = DiffDriveOdometry(separation_, radius_);
  }

 private:
  struct Wheel {
    JointHandle joint;
    double max_effort;  ///< N m
  };

  void read_side(const PluginContext& context, const char* element, std::vector<Wheel>& wheels) {
    for (const std::string& name : given_.all(element)) {
      const JointHandle joint =
          physics_.joint(context.model->name, context.plugin.model_scope + name);
      if (!joint.valid())
        throw PluginError("Failed to find " +
                          std::string(element == std::string("left_joint") ? "left" : "right") +
                          " joint [" + name + "] for model [" + context.model->name + "]" +
                          nearest_joint(*context.model, context.plugin.model_scope + name));
      wheels.push_back({joint, effort_limit(*context.model, context.plugin.model_scope + name)});
    }
    if (wheels.empty())
      throw PluginError("DiffDrive plugin of model [" + context.model->name + "] has no <" +
                        element + ">");
  }

  static double effort_limit(const Model& model, const std::string& name) {
    for (const Joint& joint : model.joints)
      if (joint.name == name && !joint.axes.empty() && joint.axes[0].effort > 0)
        return std::min(joint.axes[0].effort, 1e6);
    return 1e6;
  }

  void connect(const PluginContext& context, const std::string& prefix) {
    const std::string commands = topic_of(given_, "topic", prefix + "/cmd_vel");
    subscription_ = subscribe_gz<geometry_msgs::msg::Twist>(
        context.host, commands, [this](const geometry_msgs::msg::Twist& command) {
          forward_ = command.linear.x;
          turn_ = command.angular.z;
        });
    enable_ = subscribe_gz<std_msgs::msg::Bool>(context.host, prefix + "/enable",
                                                [this](const std_msgs::msg::Bool& message) {
                                                  enabled_ = message.data;
                                                  if (!enabled_) forward_ = turn_ = 0;
                                                });
    odometry_publisher_ = publish_gz<nav_msgs::msg::Odometry>(
        context.host, topic_of(given_, "odom_topic", prefix + "/odometry"));
    frame_publisher_ = publish_gz<tf2_msgs::msg::TFMessage>(
        context.host, topic_of(given_, "tf_topic", prefix + "/tf"));
    const std::string shown = commands.front() == '/' ? commands : "/" + commands;
    RCLCPP_INFO(context.host.node()->get_logger(),
                "DiffDrive subscribing to twist messages on [%s]", shown.c_str());
  }

  Physics& physics_;
  Parameters given_;
  double separation_, radius_;  ///< metres
  SpeedLimiter forward_limit_, turn_limit_;
  DiffDriveOdometry odometry_;
  Rate rate_;
  std::vector<Wheel> left_, right_;
  std::optional<WheelWatch> wheels_;
  std::string frame_, child_frame_;
  bool enabled_ = true;
  double forward_ = 0, turn_ = 0;  ///< the last command, m/s and rad/s; it stays until another one
  rclcpp::Subscription<geometry_msgs::msg::Twist>::SharedPtr subscription_;
  rclcpp::Subscription<std_msgs::msg::Bool>::SharedPtr enable_;
  rclcpp::Publisher<nav_msgs::msg::Odometry>::SharedPtr odometry_publisher_;
  rclcpp::Publisher<tf2_msgs::msg::TFMessage>::SharedPtr frame_publisher_;
};

}  // namespace

std::unique_ptr<System> make_diff_drive(const PluginContext& context) {
  return std::make_unique<DiffDrive>(context);
}

}  // namespace ros2wasm_sim
