// See pid_parameters.hpp.
#include "pid_controller/pid_parameters.hpp"

namespace pid_controller {
namespace {

using ros2wasm_parameters::kReadOnly;
using ros2wasm_parameters::not_empty;
using ros2wasm_parameters::one_of;
using ros2wasm_parameters::size_gt;
using ros2wasm_parameters::size_lt;
using ros2wasm_parameters::unique;
using Names = std::vector<std::string>;

void describe_gains(ros2wasm_parameters::Declarations& of, const std::string& at,
                    Params::Gains& gains) {
  of.add(at + "p", gains.p, {"Proportional gain of the PID"});
  of.add(at + "i", gains.i, {"Integral gain of the PID"});
  of.add(at + "d", gains.d, {"Derivative gain of the PID"});
  of.add(at + "u_clamp_max", gains.u_clamp_max, {"Upper limit of the output."});
  of.add(at + "u_clamp_min", gains.u_clamp_min, {"Lower limit of the output."});
  of.add(at + "antiwindup", gains.antiwindup,
         {"[Deprecated, see antiwindup_strategy] Is the integral itself kept within its limits?"});
  of.add(at + "i_clamp_max", gains.i_clamp_max, {"Upper limit of the integral."});
  of.add(at + "i_clamp_min", gains.i_clamp_min, {"Lower limit of the integral."});
  of.add(at + "antiwindup_strategy", gains.antiwindup_strategy,
         {"What keeps the integral from growing at a limit."},
         {one_of({"back_calculation", "conditional_integration", "legacy", "none"})});
  of.add(at + "tracking_time_constant", gains.tracking_time_constant,
         {"Of 'back_calculation' [s]; 0: a recommended value."});
  of.add(at + "error_deadband", gains.error_deadband, {"Smaller errors are not integrated."});
  of.add(at + "feedforward_gain", gains.feedforward_gain, {"Share of the reference."});
  of.add(at + "angle_wraparound", gains.angle_wraparound,
         {"Is the error of an angle that wraps, between -pi and pi?"});
  of.add(at + "save_i_term", gains.save_i_term, {"Keep the integral until the next activation?"});
  of.add(at + "activate_state_publisher", gains.activate_state_publisher,
         {"Publish the state of this PID on its own topic?"});
}

}  // namespace

void describe(ros2wasm_parameters::Declarations& of, Params& params) {
  of.add("dof_names", params.dof_names, {"Degrees of freedom to command.", kReadOnly},
         {unique<Names>(), not_empty<Names>()});
  of.add("reference_and_state_dof_names", params.reference_and_state_dof_names,
         {"Names of references and states, when others than ``dof_names``.", kReadOnly},
         {unique<Names>()});
  of.add("command_interface", params.command_interface, {"Interface to command.", kReadOnly},
         {not_empty<std::string>()});
  of.add("reference_and_state_interfaces", params.reference_and_state_interfaces,
         {"Interface of references and states, and that of its derivative.", kReadOnly},
         {not_empty<Names>(), size_gt<Names>(0), size_lt<Names>(3)});
  of.add("set_current_state_as_first_setpoint", params.set_current_state_as_first_setpoint,
         {"Hold the state at activation?", kReadOnly});
  of.add("use_external_measured_states", params.use_external_measured_states,
         {"Take states from a topic instead of state interfaces?"});
  of.add("enable_feedforward", params.enable_feedforward, {"Use the feedforward gains?"});
  for (const std::string& name : params.dof_names) {
    describe_gains(of, "gains." + name + ".", params.gains[name]);
  }
}

}  // namespace pid_controller
