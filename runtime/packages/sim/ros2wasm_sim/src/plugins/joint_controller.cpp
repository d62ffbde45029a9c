// JointController of Gazebo Sim: a joint keeps a velocity, by its motor or by force.
#include <std_msgs/msg/float64.hpp>

#include "plugins/gz_joints.hpp"

namespace ros2wasm_sim {
namespace {

class JointController final : public System {
 public:
  explicit JointController(const PluginContext& context) : physics_(context.physics()) {
    const Parameters given(context.plugin.xml);
    refuse_actuators(context, given);
    joints_ = gz_joints(context, given);
    by_force_ = given.flag("use_force_commands", false);
    PidSettings settings;
    settings.p = 1;
    settings.i_max = 1;
    settings.i_min = -1;
    settings.command_max = 1000;
    settings.command_min = -1000;
    pid_ = Pid(read_pid(given, settings));
    initial_ = target_ = given.number("initial_velocity", 0);
    const std::string topic = command_topic(
        context, given,
        "/model/" + context.model->name + "/joint/" + given.text("joint_name", "") + "/cmd_vel");
    subscription_ = subscribe_gz<std_msgs::msg::Float64>(
        context.host, topic,
        [this](const std_msgs::msg::Float64& message) { target_ = message.data; });
    RCLCPP_INFO(context.host.node()->get_logger(),
                "[JointController] subscribed to Double messages on [%s]", topic.c_str());
  }

  void before_step(const Now& now) override {
    if (!by_force_) {
      for (const JointHandle joint : joints_)
        physics_.set_motor(joint, target_, motor_effort(physics_, joint));
      return;
    }
    const double force = pid_.update(physics_.velocity(joints_.front()) - target_, now.step);
    for (const JointHandle joint : joints_) physics_.add_effort(joint, force);
  }

  void on_reset() override {
    pid_.reset();
    target_ = initial_;
  }

 private:
  Physics& physics_;
  std::vector<JointHandle> joints_;  ///< the first is measured, all get the same command
  bool by_force_ = false;
  Pid pid_;
  double initial_ = 0, target_ = 0;  ///< rad/s or m/s
  rclcpp::Subscription<std_msgs::msg::Float64>::SharedPtr subscription_;
};

}  // namespace

std::unique_ptr<System> make_joint_controller(const PluginContext& context) {
  return std::make_unique<JointController>(context);
}

}  // namespace ros2wasm_sim
