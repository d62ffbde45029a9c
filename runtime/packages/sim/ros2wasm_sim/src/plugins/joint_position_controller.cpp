// JointPositionController of Gazebo Sim: a joint goes to a position, by force or by velocity.
#include <std_msgs/msg/float64.hpp>

#include "plugins/gz_joints.hpp"

namespace ros2wasm_sim {
namespace {

class JointPositionController final : public System {
 public:
  explicit JointPositionController(const PluginContext& context) : physics_(context.physics()) {
    const Parameters given(context.plugin.xml);
    refuse_actuators(context, given);
    joints_ = gz_joints(context, given);
    if (given.number("joint_index", 0) != 0)
      throw PluginError("JointPositionController of model [" + context.model->name +
                        "]: only <joint_index> 0 is supported");
    by_velocity_ = given.flag("use_velocity_commands", false);
    // Without a limit of its own a joint gets there in one step.
    most_speed_ = given.has("cmd_max") ? given.number("cmd_max", kInfinity) : kInfinity;
    PidSettings settings;
    settings.p = 1;
    settings.i = 0.1;
    settings.d = 0.01;
    settings.i_max = 1;
    settings.i_min = -1;
    settings.command_max = 1000;
    settings.command_min = -1000;
    pid_ = Pid(read_pid(given, settings));
    initial_ = target_ = given.number("initial_position", 0);
    const std::string topic = command_topic(
        context, given,
        "/model/" + context.model->name + "/joint/" + given.text("joint_name", "") + "/0/cmd_pos");
    subscription_ = subscribe_gz<std_msgs::msg::Float64>(
        context.host, topic,
        [this](const std_msgs::msg::Float64& message) { target_ = message.data; });
    RCLCPP_INFO(context.host.node()->get_logger(),
                "[JointPositionController] subscribed to Double messages on [%s]", topic.c_str());
  }

  void before_step(const Now& now) override {
    const double error = physics_.position(joints_.front()) - target_;
    if (by_velocity_) {
      const double speed = std::clamp(-error / now.step, -most_speed_, most_speed_);
      for (const JointHandle joint : joints_)
        physics_.set_motor(joint, speed, motor_effort(physics_, joint));
      return;
    }
    const double force = pid_.update(error, now.step);
    for (const JointHandle joint : joints_) physics_.add_effort(joint, force);
  }

  void on_reset() override {
    pid_.reset();
    target_ = initial_;
  }

 private:
  Physics& physics_;
  std::vector<JointHandle> joints_;  ///< the first is measured, all get the same command
  bool by_velocity_ = false;
  double most_speed_ = kInfinity;  ///< rad/s or m/s
  Pid pid_;
  double initial_ = 0, target_ = 0;  ///< rad or m
  rclcpp::Subscription<std_msgs::msg::Float64>::SharedPtr subscription_;
};

}  // namespace

std::unique_ptr<System> make_joint_position_controller(const PluginContext& context) {
  return std::make_unique<JointPositionController>(context);
}

}  // namespace ros2wasm_sim
