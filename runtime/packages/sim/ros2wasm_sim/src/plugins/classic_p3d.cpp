// libgazebo_ros_p3d.so: the true pose of a link, as odometry with twists along the axes of the
// world.
#include <nav_msgs/msg/odometry.hpp>

#include "plugins/messages.hpp"
#include "plugins/plugin.hpp"
#include "sensors/noise.hpp"

namespace ros2wasm_sim {
namespace {

class ClassicP3d final : public System {
 public:
  explicit ClassicP3d(const PluginContext& context)
      : physics_(context.physics()),
        node_(context.host, context.plugin),
        random_(context.host.seed(), context.model->name + "::" + context.plugin.name),
        rate_(Parameters(context.plugin.xml).number("update_rate", 0)) {
    const Parameters given(context.plugin.xml);
    body_ = given.text("body_name", "");
    if (body_.empty()) throw PluginError("Missing <body_name>, cannot proceed");
    link_ = physics_.link(context.model->name, body_);
    if (!link_.valid()) throw PluginError("body_name: " + body_ + " does not exist");
    frame_ = given.text("frame_name", "world");
    if (frame_ != "world" && frame_ != "/world" && frame_ != "map" && frame_ != "/map") {
      reference_ = physics_.link(context.model->name, frame_);
      if (!reference_.valid()) throw PluginError("frame_name: " + frame_ + " does not exist");
    }
    const Vector3 turn = given.vector("rpy_offset");
    offset_ = {given.vector("xyz_offset"), from_roll_pitch_yaw(turn.x, turn.y, turn.z)};
    noise_ = given.number("gaussian_noise", 0);
    publisher_ = node_->create_publisher<nav_msgs::msg::Odometry>(
        "odom", rclcpp::SensorDataQoS().reliable());
  }

  void after_step(const Now& now) override {
    if (!rate_.due(now.time_ns) || publisher_->get_subscription_count() == 0) return;
    nav_msgs::msg::Odometry message;
    message.header.stamp = stamp_of(now.time_ns);
    message.header.frame_id = frame_;
    message.child_frame_id = body_;
    const Pose pose = inverse(physics_.pose(reference_)) * physics_.pose(link_);
    message.pose.pose =
        pose_message({pose.position + offset_.position, offset_.orientation * pose.orientation});
    const Motion motion = physics_.velocity(link_);
    message.twist.twist.linear = vector_message(noisy(motion.linear));
    message.twist.twist.angular = vector_message(noisy(motion.angular));
    for (std::size_t i = 0; i < 6; ++i)
      message.pose.covariance[7 * i] = message.twist.covariance[7 * i] = noise_ * noise_;
    publisher_->publish(message);
  }

  void on_reset() override { rate_.reset(); }

 private:
  Vector3 noisy(const Vector3& v) {
    if (noise_ == 0) return v;
    return {v.x + noise_ * random_.gaussian(), v.y + noise_ * random_.gaussian(),
            v.z + noise_ * random_.gaussian()};
  }

  Physics& physics_;
  PluginNode node_;
  Random random_;
  Rate rate_;
  std::string body_, frame_;
  LinkHandle link_, reference_;  ///< a reference that is not valid is the world
  Pose offset_;
  double noise_ = 0;
  rclcpp::Publisher<nav_msgs::msg::Odometry>::SharedPtr publisher_;
};

}  // namespace

std::unique_ptr<System> make_classic_p3d(const PluginContext& context) {
  return std::make_unique<ClassicP3d>(context);
}

}  // namespace ros2wasm_sim
