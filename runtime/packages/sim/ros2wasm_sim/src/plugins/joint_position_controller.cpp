// JointPositionController of Gazebo Sim: a joint goes to a position, by force or by velocity.
#include "plugins/joint_command.hpp"

namespace ros2wasm_sim {
namespace {

class JointPositionController final : public JointCommand {
 public:
  explicit JointPositionController(const PluginContext& context)
      : JointCommand(context,
                     {"JointPositionController", "initial_position", "/0/cmd_pos", defaults()}) {
    const Parameters given(context.plugin.xml);
    if (given.number("joint_index", 0) != 0)
      throw PluginError("JointPositionController of model [" + context.model->name +
                        "]: only <joint_index> 0 is supported");
    by_velocity_ = given.flag("use_velocity_commands", false);
    // Without a limit of its own a joint gets there in one step.
    most_speed_ = std::max(0.0, given.number("cmd_max", kInfinity));
  }

  void before_step(const Now& now) override {
    const double error = physics_.position(measured()) - target();
    if (by_velocity_)
      act_by_motor(std::clamp(-error / now.step, -most_speed_, most_speed_));
    else
      act_by_force(error, now.step);
  }

 private:
  static PidSettings defaults() {
    PidSettings pid;
    pid.p = 1;
    pid.i = 0.1;
    pid.d = 0.01;
    pid.i_max = 1;
    pid.i_min = -1;
    pid.command_max = 1000;
    pid.command_min = -1000;
    return pid;
  }

  bool by_velocity_ = false;
  double most_speed_ = kInfinity;  ///< rad/s or m/s
};

}  // namespace

std::unique_ptr<System> make_joint_position_controller(const PluginContext& context) {
  return std::make_unique<JointPositionController>(context);
}

}  // namespace ros2wasm_sim
