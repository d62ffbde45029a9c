// The cycle of PidController.
#include "pid_controller/pid_controller.hpp"

#include <cmath>
#include <limits>

#include "angles/angles.h"
#include "pluginlib/class_list_macros.hpp"
#include "rclcpp/logging.hpp"

namespace pid_controller {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

}  // namespace

using controller_interface::return_type;

double PidController::reference(size_t place) const {
  return ordered_exported_reference_interfaces_[place]->get_optional<double>().value_or(
      kNotANumber);
}

return_type PidController::update_reference_from_subscribers(const rclcpp::Time&,
                                                             const rclcpp::Duration&) {
  auto newest = input_reference_.try_get();
  if (!newest) return return_type::OK;
  bool is_set = true;
  bool is_taken = false;
  for (size_t i = 0; i < dofs_.size(); ++i) {
    if (std::isnan(newest->values[i])) continue;
    is_taken = true;
    is_set &= ordered_exported_reference_interfaces_[i]->set_value(newest->values[i]);
    if (has_derivative_ && !std::isnan(newest->values_dot[i])) {
      is_set &= ordered_exported_reference_interfaces_[dofs_.size() + i]->set_value(
          newest->values_dot[i]);
    }
    newest->values[i] = kNotANumber;
  }
  if (is_taken) input_reference_.try_set(*newest);
  if (!is_set) RCLCPP_DEBUG(get_node()->get_logger(), "Unable to set a reference interface");
  return return_type::OK;
}

void PidController::read_measured_state() {
  const size_t dofs = dofs_.size();
  if (params_.use_external_measured_states) {
    const auto newest = input_state_.try_get();
    if (!newest) return;
    for (size_t i = 0; i < dofs; ++i) {
      measured_[i] = newest->values[i];
      if (has_derivative_) {
        measured_[dofs + i] = i < newest->values_dot.size() ? newest->values_dot[i] : kNotANumber;
      }
    }
    return;
  }
  for (size_t i = 0; i < measured_.size(); ++i) {
    measured_[i] = state_interfaces_[i].get_optional().value_or(measured_[i]);
  }
}

double PidController::error_of(size_t dof, double reference) const {
  return params_.gains.at(params_.dof_names[dof]).angle_wraparound
             ? angles::shortest_angular_distance(measured_[dof], reference)
             : reference - measured_[dof];
}

double PidController::command_of(size_t dof, const rclcpp::Duration& period) {
  const size_t dofs = dofs_.size();
  const double wanted = reference(dof);
  if (!std::isfinite(wanted) || !std::isfinite(measured_[dof])) return kNotANumber;
  const double wanted_rate = has_derivative_ ? reference(dofs + dof) : kNotANumber;
  double command = 0.0;
  if (is_feedforward_enabled_) {
    const double gain = params_.gains.at(params_.dof_names[dof]).feedforward_gain;
    const double forward = has_derivative_ ? wanted_rate : wanted;
    if (std::isfinite(forward)) command = forward * gain;
  }
  const double error = error_of(dof, wanted);
  if (has_derivative_ && std::isfinite(wanted_rate) && std::isfinite(measured_[dofs + dof])) {
    return command +
           pids_[dof]->compute_command(error, wanted_rate - measured_[dofs + dof], period);
  }
  return command + pids_[dof]->compute_command(error, period);
}

return_type PidController::update_and_write_commands(const rclcpp::Time& time,
                                                     const rclcpp::Duration& period) {
  if (param_listener_->try_update_params(params_)) {
    is_feedforward_enabled_ = params_.enable_feedforward;
    set_gains();
  }
  read_measured_state();
  for (size_t i = 0; i < measured_.size() && i < ordered_exported_state_interfaces_.size(); ++i) {
    if (!ordered_exported_state_interfaces_[i]->set_value(measured_[i])) {
      RCLCPP_DEBUG(get_node()->get_logger(), "Unable to export the state of %s",
                   ordered_exported_state_interfaces_[i]->get_name().c_str());
    }
  }
  for (size_t i = 0; i < dofs_.size(); ++i) {
    const double command = command_of(i, period);
    if (!std::isnan(command) && !command_interfaces_[i].set_value(command)) {
      RCLCPP_ERROR(get_node()->get_logger(), "Failed to set command value for %s",
                   command_interfaces_[i].get_name().c_str());
    }
  }
  publish_state(time, period);
  return return_type::OK;
}

void PidController::publish_state(const rclcpp::Time& time, const rclcpp::Duration& period) {
  if (!state_publisher_) return;
  const size_t dofs = dofs_.size();
  state_message_.header.stamp = time;
  for (size_t i = 0; i < dofs; ++i) {
    auto& state = state_message_.dof_states[i];
    state.reference = reference(i);
    state.feedback = measured_[i];
    state.error = error_of(i, state.reference);
    if (has_derivative_) {
      state.feedback_dot = measured_[dofs + i];
      state.error_dot = reference(dofs + i) - measured_[dofs + i];
    }
    state.time_step = period.seconds();
    state.output = command_interfaces_[i].get_optional().value_or(state.output);
  }
  state_publisher_->try_publish(state_message_);
}

}  // namespace pid_controller

PLUGINLIB_EXPORT_CLASS(pid_controller::PidController,
                       controller_interface::ChainableControllerInterface)
