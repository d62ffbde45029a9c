// ApplyJointForce of Gazebo Sim: the effort of a joint is the last one that was sent.
#include <std_msgs/msg/float64.hpp>

#include "plugins/gz_joints.hpp"

namespace ros2wasm_sim {
namespace {

class ApplyJointForce final : public System {
 public:
  explicit ApplyJointForce(const PluginContext& context) : physics_(context.physics()) {
    const Parameters given(context.plugin.xml);
    const std::string name = given.text("joint_name", "");
    joint_ = gz_joint(context, name);
    subscription_ = subscribe_gz<std_msgs::msg::Float64>(
        context.host,
        topic_of(given, "topic", "/model/" + context.model->name + "/joint/" + name + "/cmd_force"),
        [this](const std_msgs::msg::Float64& message) { force_ = message.data; });
  }

  void before_step(const Now&) override { physics_.add_effort(joint_, force_); }
  void on_reset() override { force_ = 0; }

 private:
  Physics& physics_;
  JointHandle joint_;
  double force_ = 0;  ///< N or N m
  rclcpp::Subscription<std_msgs::msg::Float64>::SharedPtr subscription_;
};

}  // namespace

std::unique_ptr<System> make_apply_joint_force(const PluginContext& context) {
  return std::make_unique<ApplyJointForce>(context);
}

}  // namespace ros2wasm_sim
