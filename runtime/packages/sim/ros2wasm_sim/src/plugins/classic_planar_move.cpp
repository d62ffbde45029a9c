// libgazebo_ros_planar_move.so: moves a model over the ground with the velocities of `cmd_vel`.
#include <geometry_msgs/msg/twist.hpp>
#include <tf2_ros/transform_broadcaster.hpp>

#include <cmath>

#include "plugins/classic_odometry.hpp"

namespace ros2wasm_sim {
namespace {

class ClassicPlanarMove final : public System {
 public:
  explicit ClassicPlanarMove(const PluginContext& context)
      : simulation_(context.simulation),
        node_(context.host, context.plugin),
        model_(context.model->name),
        odometry_(Parameters(context.plugin.xml)),
        update_rate_(Parameters(context.plugin.xml).number("update_rate", 20)),
        publish_rate_(Parameters(context.plugin.xml).number("publish_rate", 20)) {
    const Parameters given(context.plugin.xml);
    subscription_ = node_->create_subscription<geometry_msgs::msg::Twist>(
        "cmd_vel", rclcpp::QoS(1), [this](const geometry_msgs::msg::Twist& command) {
          command_ = {command.linear.x, command.linear.y, command.angular.z};
        });
    RCLCPP_INFO(node_->get_logger(), "Subscribed to [%s]", subscription_->get_topic_name());
    if (given.flag("publish_odom", true)) {
      publisher_ = node_->create_publisher<nav_msgs::msg::Odometry>("odom", rclcpp::QoS(1));
      RCLCPP_INFO(node_->get_logger(), "Advertise odometry on [%s]", publisher_->get_topic_name());
    }
    if (given.flag("publish_odom_tf", true)) {
      frames_ = std::make_unique<tf2_ros::TransformBroadcaster>(node_.get());
      RCLCPP_INFO(node_->get_logger(), "Publishing odom transforms between [%s] and [%s]",
                  odometry_.frame().c_str(), odometry_.base().c_str());
    }
  }

  void before_step(const Now& now) override {
    const Model* model = simulation_.model(model_);
    if (model == nullptr || !update_rate_.due(now.time_ns)) return;
    const double yaw = yaw_of(simulation_.model_pose(*model).orientation);
    const Vector3 across = rotate(from_roll_pitch_yaw(0, 0, yaw), {command_.x, command_.y, 0});
    simulation_.physics().set_model_velocity(model_, {across, {0, 0, command_.z}});
  }

  void after_step(const Now& now) override {
    const Model* model = simulation_.model(model_);
    if (model == nullptr || !publish_rate_.due(now.time_ns)) return;
    const Pose pose = simulation_.model_pose(*model);
    const auto stamp = stamp_of(now.time_ns);
    if (frames_ != nullptr)
      frames_->sendTransform(transform_message(stamp, odometry_.frame(), odometry_.base(), pose));
    if (publisher_ == nullptr) return;
    publisher_->publish(odometry_.message(stamp, pose, level_motion(simulation_, *model, pose)));
  }

  void on_reset() override {
    update_rate_.reset();
    publish_rate_.reset();
    command_ = {};
  }

 private:
  Simulation& simulation_;
  PluginNode node_;
  std::string model_;
  ClassicOdometry odometry_;
  Rate update_rate_, publish_rate_;
  Vector3 command_;  ///< m/s forward and to the left, rad/s; it stays until another one
  rclcpp::Subscription<geometry_msgs::msg::Twist>::SharedPtr subscription_;
  rclcpp::Publisher<nav_msgs::msg::Odometry>::SharedPtr publisher_;
  std::unique_ptr<tf2_ros::TransformBroadcaster> frames_;
};

}  // namespace

std::unique_ptr<System> make_classic_planar_move(const PluginContext& context) {
  return std::make_unique<ClassicPlanarMove>(context);
}

}  // namespace ros2wasm_sim
