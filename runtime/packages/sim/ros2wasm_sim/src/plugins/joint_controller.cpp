// JointController of Gazebo Sim: a joint keeps a velocity, by its motor or by force.
#include "plugins/joint_command.hpp"

namespace ros2wasm_sim {
namespace {

class JointController final : public JointCommand {
 public:
  explicit JointController(const PluginContext& context)
      : JointCommand(context, {"JointController", "initial_velocity", "/cmd_vel", defaults()}),
        by_force_(Parameters(context.plugin.xml).flag("use_force_commands", false)) {}

  void before_step(const Now& now) override {
    if (by_force_)
      act_by_force(physics_.velocity(measured()) - target(), now.step);
    else
      act_by_motor(target());
  }

 private:
  static PidSettings defaults() {
    PidSettings pid;
    pid.p = 1;
    pid.i_max = 1;
    pid.i_min = -1;
    pid.command_max = 1000;
    pid.command_min = -1000;
    return pid;
  }

  bool by_force_;
};

}  // namespace

std::unique_ptr<System> make_joint_controller(const PluginContext& context) {
  return std::make_unique<JointController>(context);
}

}  // namespace ros2wasm_sim
