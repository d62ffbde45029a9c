// See jtc_parameters.hpp.
#include "joint_trajectory_controller/jtc_parameters.hpp"

#include <algorithm>

namespace joint_trajectory_controller {
namespace {

using ros2wasm_parameters::Declarations;
using ros2wasm_parameters::gt_eq;
using ros2wasm_parameters::kReadOnly;
using ros2wasm_parameters::one_of;
using ros2wasm_parameters::Rule;
using ros2wasm_parameters::size_gt;
using ros2wasm_parameters::subset_of;
using ros2wasm_parameters::unique;
using Names = std::vector<std::string>;

bool has(const Names& names, const char* name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string check_command_interfaces(const std::string&, const Names& names) {
  if (has(names, "velocity") && names.size() > 1 && !has(names, "position")) {
    return "'velocity' command interface can be used either alone or 'position' command interface "
           "has to be present";
  }
  if (has(names, "acceleration") && !has(names, "velocity") && !has(names, "position")) {
    return "'acceleration' command interface can only be used if 'velocity' and 'position' "
           "command interfaces are present";
  }
  const bool is_effort_right = names.size() == 1 || (names.size() == 2 && has(names, "position"));
  if (has(names, "effort") && !is_effort_right) {
    return "'effort' command interface has to be used alone or with a 'position' interface";
  }
  return "";
}

std::string check_state_interfaces(const std::string&, const Names& names) {
  if (has(names, "velocity") && !has(names, "position")) {
    return "'velocity' state interface cannot be used if 'position' interface is missing.";
  }
  if (has(names, "acceleration") && (!has(names, "position") || !has(names, "velocity"))) {
    return "'acceleration' state interface cannot be used if 'position' and 'velocity' interfaces "
           "are not present.";
  }
  return "";
}

void describe_interfaces(Declarations& of, Params& params) {
  of.add("joints", params.joints, {"Joint names of the system", kReadOnly},
         {unique<Names>(), size_gt<Names>(0)});
  of.add("command_joints", params.command_joints,
         {"Joints to command; when empty, ``joints``.", kReadOnly}, {unique<Names>()});
  of.add("command_interfaces", params.command_interfaces,
         {"Command interfaces of all joints", kReadOnly},
         {unique<Names>(), size_gt<Names>(0),
          subset_of({"position", "velocity", "acceleration", "effort"}),
          Rule<Names>{check_command_interfaces}});
  of.add("state_interfaces", params.state_interfaces, {"State interfaces of all joints", kReadOnly},
         {unique<Names>(), size_gt<Names>(0), subset_of({"position", "velocity", "acceleration"}),
          Rule<Names>{check_state_interfaces}});
  auto& scaling = params.speed_scaling;
  of.add("speed_scaling.initial_scaling_factor", scaling.initial_scaling_factor,
         {"The share of the speed at the start.", kReadOnly}, {gt_eq(0.0)});
  of.add("speed_scaling.state_interface", scaling.state_interface,
         {"Full name of the state interface of the share.", kReadOnly});
  of.add("speed_scaling.command_interface", scaling.command_interface,
         {"Full name of the command interface of the share.", kReadOnly});
}

void describe_gains(Declarations& of, const std::string& at, Params::Gains& gains) {
  of.add(at + "p", gains.p, {"Proportional gain of the PID"});
  of.add(at + "i", gains.i, {"Integral gain of the PID"});
  of.add(at + "d", gains.d, {"Derivative gain of the PID"});
  of.add(at + "i_clamp", gains.i_clamp, {"[deprecated] Limit of the integral, both ways."});
  of.add(at + "i_clamp_max", gains.i_clamp_max, {"Upper limit of the integral."});
  of.add(at + "i_clamp_min", gains.i_clamp_min, {"Lower limit of the integral."});
  of.add(at + "ff_velocity_scale", gains.ff_velocity_scale, {"Share of the wanted velocity."});
  of.add(at + "u_clamp_max", gains.u_clamp_max, {"Upper limit of the output."});
  of.add(at + "u_clamp_min", gains.u_clamp_min, {"Lower limit of the output."});
  of.add(at + "antiwindup_strategy", gains.antiwindup_strategy,
         {"What keeps the integral from growing at a limit.", kReadOnly},
         {one_of({"back_calculation", "conditional_integration", "legacy", "none"})});
  of.add(at + "tracking_time_constant", gains.tracking_time_constant,
         {"Of 'back_calculation' [s]; 0: a recommended value."});
  of.add(at + "error_deadband", gains.error_deadband, {"Smaller errors are not integrated."});
}

void describe_constraints(Declarations& of, Params& params) {
  auto& constraints = params.constraints;
  of.add("constraints.stopped_velocity_tolerance", constraints.stopped_velocity_tolerance,
         {"The velocity below which a joint stands at the end."});
  of.add("constraints.goal_time", constraints.goal_time,
         {"Seconds that joints may come late; 0: no limit."}, {gt_eq(0.0)});
  of.add("constraints.decelerate_on_cancel", constraints.decelerate_on_cancel,
         {"Brake within max_deceleration_on_cancel when a goal ends early?", kReadOnly});
  for (const std::string& joint : params.joints) {
    const std::string at = "constraints." + joint + ".";
    Params::JointConstraints& of_joint = constraints.joints[joint];
    of.add(at + "trajectory", of_joint.trajectory, {"Tolerance on the way; 0: no limit."});
    of.add(at + "goal", of_joint.goal, {"Tolerance at the end; 0: no limit."});
    of.add(at + "max_deceleration_on_cancel", of_joint.max_deceleration_on_cancel,
           {"Greatest deceleration when a goal ends early.", kReadOnly}, {gt_eq(0.0)});
  }
}

}  // namespace

void describe(Declarations& of, Params& params) {
  describe_interfaces(of, params);
  of.add("allow_partial_joints_goal", params.allow_partial_joints_goal,
         {"Accept goals that name only some joints?"});
  of.add("open_loop_control", params.open_loop_control, {"[deprecated]", kReadOnly});
  of.add("interpolate_from_desired_state", params.interpolate_from_desired_state,
         {"Start from what was commanded last instead of from what is measured?", kReadOnly});
  of.add("allow_integration_in_goal_trajectories", params.allow_integration_in_goal_trajectories,
         {"Accept points without positions?"});
  of.add("set_last_command_interface_value_as_state_on_activation",
         params.set_last_command_interface_value_as_state_on_activation,
         {"Hold the last command at activation instead of the measured state?"});
  of.add("action_monitor_rate", params.action_monitor_rate,
         {"Rate at which feedback of the action is published [Hz].", kReadOnly}, {gt_eq(0.1)});
  of.add("interpolation_method", params.interpolation_method,
         {"What is between two points.", kReadOnly}, {one_of({"splines", "none"})});
  of.add("allow_nonzero_velocity_at_trajectory_end",
         params.allow_nonzero_velocity_at_trajectory_end,
         {"Accept trajectories that end with a velocity?"});
  of.add("cmd_timeout", params.cmd_timeout,
         {"Seconds after the end without a new trajectory until the joints are held; 0: never."});
  for (const std::string& joint : params.joints) {
    describe_gains(of, "gains." + joint + ".", params.gains[joint]);
  }
  describe_constraints(of, params);
}

}  // namespace joint_trajectory_controller
