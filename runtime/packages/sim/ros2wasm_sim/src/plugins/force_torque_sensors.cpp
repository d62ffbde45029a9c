// Wrenches in joints: libgazebo_ros_ft_sensor.so, and `force_torque` of Gazebo Sim.
#include <geometry_msgs/msg/wrench_stamped.hpp>

#include <algorithm>
#include <vector>

#include "plugins/gz_sensor.hpp"
#include "plugins/messages.hpp"
#include "sdf/nearest_name.hpp"
#include "sensors/force_torque.hpp"

namespace ros2wasm_sim {
namespace {

using geometry_msgs::msg::WrenchStamped;

/// How the child acts on the joint, along the child's axes and about the joint, as in Gazebo.
class ClassicFtSensor final : public System {
 public:
  explicit ClassicFtSensor(const PluginContext& context)
      : physics_(context.physics()),
        node_(context.host, context.plugin),
        random_(context.host.seed(), context.model->name + "::" + context.plugin.name),
        rate_(Parameters(context.plugin.xml).number("update_rate", 0)) {
    const Parameters given(context.plugin.xml);
    if (given.has("body_name"))
      throw PluginError(
          "ft_sensor on a link (<body_name>) is not supported: name its joint with "
          "<joint_name>");
    if (!given.has("joint_name"))
      throw PluginError("ft_sensor plugin missing <body_name> and <joint_name>, cannot proceed");
    const Joint& joint =
        joint_named(context, context.plugin.model_scope + given.text("joint_name", ""));
    if (given.has("frame_name"))
      RCLCPP_WARN(node_->get_logger(), "<frame_name> can be set only for ft_sensor on links.");
    child_ = physics_.link(context.model->name, joint.child);
    physics_.watch_wrench(child_);
    anchor_ = joint.pose.position;
    frame_ = joint.child;
    noise_ = given.number("gaussian_noise", 0);
    RCLCPP_INFO(node_->get_logger(), "ft_sensor plugin reporting wrench values to the frame [%s]",
                frame_.c_str());
    publisher_ = node_->create_publisher<WrenchStamped>("wrench", rclcpp::QoS(1));
    RCLCPP_INFO(node_->get_logger(), "Publishing wrenches on topic [%s]",
                publisher_->get_topic_name());
  }

  void after_step(const Now& now) override {
    if (!rate_.due(now.time_ns) || publisher_->get_subscription_count() == 0) return;
    const Wrench on_child = about(anchor_, physics_.wrench(child_));
    WrenchStamped message;
    message.header.stamp = stamp_of(now.time_ns);
    message.header.frame_id = frame_;
    message.wrench.force = vector_message(noisy(-1.0 * on_child.force));
    message.wrench.torque = vector_message(noisy(-1.0 * on_child.torque));
    publisher_->publish(message);
  }

  void on_reset() override { rate_.reset(); }

 private:
  static const Joint& joint_named(const PluginContext& context, const std::string& name) {
    const std::vector<Joint>& joints = context.model->joints;
    const auto found = std::find_if(joints.begin(), joints.end(),
                                    [&](const Joint& joint) { return joint.name == name; });
    if (found != joints.end()) return *found;
    std::vector<std::string> known;
    for (const Joint& joint : joints) known.push_back(joint.name);
    const std::string nearest = nearest_name(name, known);
    throw PluginError("Joint [" + name + "] does not exist. Aborting" +
                      (nearest.empty() ? "" : "; did you mean [" + nearest + "]?"));
  }

  Vector3 noisy(Vector3 v) {
    if (noise_ == 0) return v;
    v.x += noise_ * random_.gaussian();
    v.y += noise_ * random_.gaussian();
    v.z += noise_ * random_.gaussian();
    return v;
  }

  Physics& physics_;
  PluginNode node_;
  Random random_;
  Rate rate_;
  LinkHandle child_;
  Vector3 anchor_;  ///< the joint, in the child
  std::string frame_;
  double noise_ = 0;
  rclcpp::Publisher<WrenchStamped>::SharedPtr publisher_;
};

class GzForceTorque final : public GzSensor<WrenchStamped> {
 public:
  explicit GzForceTorque(const PluginContext& context)
      : GzSensor(context, "/forcetorque"),
        sensor_(*context.sensor, context.physics(), context.model->name, *context.joint,
                context.host.seed()) {
    for (const std::string& warning : sensor_.warnings())
      RCLCPP_WARN(context.host.node()->get_logger(), "%s", warning.c_str());
  }

 private:
  WrenchStamped measure() override {
    const Wrench wrench = sensor_.measure();
    WrenchStamped message;
    message.wrench.force = vector_message(wrench.force);
    message.wrench.torque = vector_message(wrench.torque);
    return message;
  }

  ForceTorque sensor_;
};

}  // namespace

std::unique_ptr<System> make_classic_ft_sensor(const PluginContext& context) {
  return std::make_unique<ClassicFtSensor>(context);
}
std::unique_ptr<System> make_gz_force_torque(const PluginContext& context) {
  return std::make_unique<GzForceTorque>(context);
}

}  // namespace ros2wasm_sim
