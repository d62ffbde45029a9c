// The life of PidController: parameters, topics, interfaces.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>

#include "pid_controller/pid_controller.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/qos.hpp"

namespace pid_controller {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

control_msgs::msg::MultiDOFCommand nothing_for(const std::vector<std::string>& dofs) {
  control_msgs::msg::MultiDOFCommand message;
  message.dof_names = dofs;
  message.values.assign(dofs.size(), kNotANumber);
  message.values_dot.assign(dofs.size(), kNotANumber);
  return message;
}

}  // namespace

using controller_interface::CallbackReturn;
using controller_interface::interface_configuration_type;
using controller_interface::InterfaceConfiguration;

CallbackReturn PidController::on_init() {
  try {
    param_listener_ = std::make_shared<ParamListener>(get_node(), describe);
    params_ = param_listener_->get_params();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "Exception thrown during controller's init with message: %s \n",
                 error.what());
    return CallbackReturn::ERROR;
  }
  return CallbackReturn::SUCCESS;
}

bool PidController::configure_parameters() {
  param_listener_->refresh_dynamic_parameters();
  params_ = param_listener_->get_params();
  is_feedforward_enabled_ = params_.enable_feedforward;
  dofs_ = params_.reference_and_state_dof_names.empty() ? params_.dof_names
                                                        : params_.reference_and_state_dof_names;
  has_derivative_ = params_.reference_and_state_interfaces.size() == 2;
  if (params_.dof_names.size() != dofs_.size()) {
    RCLCPP_FATAL(get_node()->get_logger(),
                 "Size of 'dof_names' (%zu) and 'reference_and_state_dof_names' (%zu) parameters "
                 "has to be the same!",
                 params_.dof_names.size(), dofs_.size());
    return false;
  }
  pids_.clear();
  for (size_t i = 0; i < dofs_.size(); ++i) {
    pids_.push_back(std::make_unique<control_toolbox::Pid>());
  }
  set_gains();
  return true;
}

void PidController::set_gains() {
  for (size_t i = 0; i < pids_.size(); ++i) {
    const Params::Gains& gains = params_.gains.at(params_.dof_names[i]);
    control_toolbox::AntiWindupStrategy strategy;
    strategy.set_type(gains.antiwindup_strategy);
    strategy.legacy_antiwindup = gains.antiwindup;
    strategy.i_max = gains.i_clamp_max;
    strategy.i_min = gains.i_clamp_min;
    strategy.tracking_time_constant = gains.tracking_time_constant;
    strategy.error_deadband = gains.error_deadband;
    pids_[i]->set_gains(gains.p, gains.i, gains.d, gains.u_clamp_max, gains.u_clamp_min, strategy);
  }
}

CallbackReturn PidController::on_configure(const rclcpp_lifecycle::State&) {
  if (!configure_parameters()) return CallbackReturn::FAILURE;
  input_reference_.set(nothing_for(dofs_));
  input_state_.set(nothing_for(dofs_));
  measured_.assign(dofs_.size() * params_.reference_and_state_interfaces.size(), kNotANumber);
  create_topics();
  state_message_.dof_states.resize(dofs_.size());
  for (size_t i = 0; i < dofs_.size(); ++i) state_message_.dof_states[i].name = dofs_[i];
  RCLCPP_INFO(get_node()->get_logger(), "configure successful");
  return CallbackReturn::SUCCESS;
}

void PidController::create_topics() {
  const auto node = get_node();
  rclcpp::SystemDefaultsQoS qos;
  qos.keep_last(1);
  qos.best_effort();
  reference_subscription_ = node->create_subscription<ControllerReferenceMsg>(
      "~/reference", qos,
      [this](const std::shared_ptr<ControllerReferenceMsg> message) { on_reference(*message); });
  if (params_.use_external_measured_states) {
    state_subscription_ = node->create_subscription<ControllerMeasuredStateMsg>(
        "~/measured_state", qos, [this](const std::shared_ptr<ControllerMeasuredStateMsg> message) {
          on_measured_state(*message);
        });
  }
  feedforward_service_ = node->create_service<ControllerModeSrvType>(
      "~/set_feedforward_control",
      [this](const std::shared_ptr<ControllerModeSrvType::Request> request,
             std::shared_ptr<ControllerModeSrvType::Response> response) {
        is_feedforward_enabled_ = request->data;
        RCLCPP_WARN(get_node()->get_logger(),
                    "This service will be deprecated in favour of setting the "
                    "``feedforward_gain`` parameter to a non-zero value.");
        response->success = true;
      });
  state_publisher_ = std::make_unique<realtime_tools::RealtimePublisher<ControllerStateMsg>>(
      node->create_publisher<ControllerStateMsg>("~/controller_state",
                                                 rclcpp::SystemDefaultsQoS()));
}

void PidController::on_reference(const ControllerReferenceMsg& message) {
  const auto logger = get_node()->get_logger();
  const size_t expected = dofs_.size();
  if (message.values.size() != expected ||
      (!message.dof_names.empty() && message.dof_names.size() != expected)) {
    RCLCPP_ERROR(logger,
                 "Size of input data names (%zu) and/or values (%zu) is not matching the expected "
                 "size (%zu).",
                 message.dof_names.size(), message.values.size(), expected);
    return;
  }
  if (message.dof_names.empty()) {
    RCLCPP_WARN(logger,
                "Reference massage does not have DoF names defined. "
                "Assuming that value have order as defined state DoFs");
  }
  ControllerReferenceMsg sorted = nothing_for(dofs_);
  for (size_t i = 0; i < expected; ++i) {
    const std::string& name = message.dof_names.empty() ? dofs_[i] : message.dof_names[i];
    const auto found = std::find(dofs_.begin(), dofs_.end(), name);
    if (found == dofs_.end()) {
      RCLCPP_WARN(logger, "DoF name '%s' not found in the defined list of state DoFs.",
                  name.c_str());
      return;
    }
    const auto place = static_cast<size_t>(found - dofs_.begin());
    sorted.values[place] = message.values[i];
    if (i < message.values_dot.size()) sorted.values_dot[place] = message.values_dot[i];
  }
  input_reference_.set(sorted);
}

void PidController::on_measured_state(const ControllerMeasuredStateMsg& message) {
  const auto logger = get_node()->get_logger();
  const auto has_size = [&](const char* what, size_t size) {
    if (size == dofs_.size()) return true;
    RCLCPP_ERROR(logger, "Size of input data %s (%zu) is not matching the expected size (%zu).",
                 what, size, dofs_.size());
    return false;
  };
  if (!has_size("names", message.dof_names.size()) || !has_size("values", message.values.size())) {
    return;
  }
  if (!message.values_dot.empty()) {
    if (!has_derivative_) {
      RCLCPP_ERROR(logger,
                   "The reference_and_state_interfaces parameter has to have two interfaces [the "
                   "interface and the derivative of the interface], in order to use the "
                   "values_dot field.");
      return;
    }
    if (!has_size("values_dot", message.values_dot.size())) return;
  }
  input_state_.set(message);
}

CallbackReturn PidController::on_cleanup(const rclcpp_lifecycle::State&) {
  dofs_.clear();
  pids_.clear();
  return CallbackReturn::SUCCESS;
}

InterfaceConfiguration PidController::command_interface_configuration() const {
  InterfaceConfiguration wanted{interface_configuration_type::INDIVIDUAL, {}};
  for (const std::string& name : params_.dof_names) {
    wanted.names.push_back(name + "/" + params_.command_interface);
  }
  return wanted;
}

InterfaceConfiguration PidController::state_interface_configuration() const {
  if (params_.use_external_measured_states) return {interface_configuration_type::NONE, {}};
  InterfaceConfiguration wanted{interface_configuration_type::INDIVIDUAL, {}};
  for (const std::string& interface : params_.reference_and_state_interfaces) {
    for (const std::string& name : dofs_) wanted.names.push_back(name + "/" + interface);
  }
  return wanted;
}

std::vector<hardware_interface::CommandInterface::SharedPtr>
PidController::on_export_reference_interfaces_list() {
  std::vector<hardware_interface::CommandInterface::SharedPtr> exported;
  for (const std::string& interface : params_.reference_and_state_interfaces) {
    for (const std::string& name : dofs_) {
      exported.push_back(std::make_shared<hardware_interface::CommandInterface>(
          std::string(get_node()->get_name()) + "/" + name, interface));
    }
  }
  return exported;
}

std::vector<hardware_interface::StateInterface::SharedPtr>
PidController::on_export_state_interfaces_list() {
  std::vector<hardware_interface::StateInterface::SharedPtr> exported;
  for (const std::string& interface : params_.reference_and_state_interfaces) {
    for (const std::string& name : dofs_) {
      exported.push_back(std::make_shared<hardware_interface::StateInterface>(
          std::string(get_node()->get_name()) + "/" + name, interface));
    }
  }
  return exported;
}

bool PidController::on_set_chained_mode(bool) {
  return true;
}

void PidController::set_first_setpoint() {
  read_measured_state();
  for (size_t i = 0; i < measured_.size(); ++i) {
    if (std::isnan(measured_[i])) continue;
    if (!ordered_exported_reference_interfaces_[i]->set_value(measured_[i])) {
      RCLCPP_DEBUG(get_node()->get_logger(), "Unable to set a reference interface");
    }
  }
}

CallbackReturn PidController::on_activate(const rclcpp_lifecycle::State&) {
  input_reference_.try_set(nothing_for(dofs_));
  if (!params_.use_external_measured_states) input_state_.try_set(nothing_for(dofs_));
  std::fill(measured_.begin(), measured_.end(), kNotANumber);
  bool is_set = true;
  for (const auto& one : ordered_exported_reference_interfaces_) {
    is_set &= one->set_value(kNotANumber);
  }
  for (const auto& one : ordered_exported_state_interfaces_) is_set &= one->set_value(kNotANumber);
  if (!is_set) RCLCPP_DEBUG(get_node()->get_logger(), "Unable to reset an interface to NaN");
  if (params_.set_current_state_as_first_setpoint) set_first_setpoint();
  for (size_t i = 0; i < pids_.size(); ++i) {
    pids_[i]->reset(params_.gains.at(params_.dof_names[i]).save_i_term);
  }
  return CallbackReturn::SUCCESS;
}

}  // namespace pid_controller
