// libgazebo_ros_joint_state_publisher.so: positions and velocities of the joints that are named.
#include <sensor_msgs/msg/joint_state.hpp>

#include "checks/model_checks.hpp"
#include "plugins/plugin.hpp"

namespace ros2wasm_sim {
namespace {

class ClassicJointStatePublisher final : public System {
 public:
  explicit ClassicJointStatePublisher(const PluginContext& context)
      : physics_(context.physics()),
        node_(context.host, context.plugin),
        rate_(Parameters(context.plugin.xml).number("update_rate", 100)) {
    const auto names = Parameters(context.plugin.xml).all("joint_name");
    if (names.empty()) throw PluginError("Plugin missing <joint_name>s");
    for (const std::string& name : names) {
      const JointHandle joint =
          physics_.joint(context.model->name, context.plugin.model_scope + name);
      if (!joint.valid()) {
        RCLCPP_ERROR(node_->get_logger(), "Joint %s does not exist!%s", name.c_str(),
                     nearest_joint(*context.model, context.plugin.model_scope + name).c_str());
        continue;
      }
      joints_.push_back(joint);
      message_.name.push_back(name);
      RCLCPP_INFO(node_->get_logger(), "Going to publish joint [%s]", name.c_str());
    }
    if (joints_.empty()) throw PluginError("No joints found.");
    message_.position.resize(joints_.size());
    message_.velocity.resize(joints_.size());
    publisher_ =
        node_->create_publisher<sensor_msgs::msg::JointState>("joint_states", rclcpp::QoS(1000));
  }

  void after_step(const Now& now) override {
    if (!rate_.due(now.time_ns)) return;
    message_.header.stamp = stamp_of(now.time_ns);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      message_.position[i] = physics_.position(joints_[i]);
      message_.velocity[i] = physics_.velocity(joints_[i]);
    }
    publisher_->publish(message_);
  }

  void on_reset() override { rate_.reset(); }

 private:
  Physics& physics_;
  PluginNode node_;
  Rate rate_;
  std::vector<JointHandle> joints_;
  sensor_msgs::msg::JointState message_;
  rclcpp::Publisher<sensor_msgs::msg::JointState>::SharedPtr publisher_;
};

}  // namespace

std::unique_ptr<System> make_classic_joint_state_publisher(const PluginContext& context) {
  return std::make_unique<ClassicJointStatePublisher>(context);
}

}  // namespace ros2wasm_sim
