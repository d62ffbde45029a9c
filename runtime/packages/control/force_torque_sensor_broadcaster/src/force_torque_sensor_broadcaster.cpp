// See force_torque_sensor_broadcaster.hpp.
#include "force_torque_sensor_broadcaster/force_torque_sensor_broadcaster.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>

#include "pluginlib/class_list_macros.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/qos.hpp"

namespace force_torque_sensor_broadcaster {
namespace {

constexpr const char* kAxisNames[kAxes] = {"force.x",  "force.y",  "force.z",
                                           "torque.x", "torque.y", "torque.z"};

void describe(ros2wasm_parameters::Declarations& of, Params& params) {
  of.add("frame_id", params.frame_id, {"The frame of the values."},
         {ros2wasm_parameters::not_empty<std::string>()});
  of.add("sensor_name", params.sensor_name,
         {"Name of the sensor, before force.x to torque.z; or else the names of interfaces."});
  for (size_t i = 0; i < kAxes; ++i) {
    const std::string axis = kAxisNames[i];
    of.add("interface_names." + axis, params.interface_names[i], {"State interface of " + axis});
    of.add("offset." + axis, params.offset[i], {"Is added to " + axis});
    of.add("multiplier." + axis, params.multiplier[i], {"Factor of " + axis + " after the offset"});
  }
}

std::array<double*, kAxes> values_of(geometry_msgs::msg::Wrench& wrench) {
  return {&wrench.force.x,  &wrench.force.y,  &wrench.force.z,
          &wrench.torque.x, &wrench.torque.y, &wrench.torque.z};
}

}  // namespace

using controller_interface::CallbackReturn;
using controller_interface::interface_configuration_type;
using controller_interface::InterfaceConfiguration;
using controller_interface::return_type;

CallbackReturn ForceTorqueSensorBroadcaster::on_init() {
  try {
    param_listener_ = std::make_shared<ParamListener>(get_node(), describe);
    params_ = param_listener_->get_params();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "Exception thrown during init stage with message: %s \n", error.what());
    return CallbackReturn::ERROR;
  }
  return CallbackReturn::SUCCESS;
}

bool ForceTorqueSensorBroadcaster::has_filters() {
  // They are not declared: the chain would read what the file gives.
  const auto& given = get_node()->get_node_parameters_interface()->get_parameter_overrides();
  return std::any_of(given.begin(), given.end(), [](const auto& parameter) {
    return parameter.first.rfind("sensor_filter_chain", 0) == 0;
  });
}

bool ForceTorqueSensorBroadcaster::choose_sensor() {
  const auto logger = get_node()->get_logger();
  const auto& names = params_.interface_names;
  const bool has_names = std::any_of(names.begin(), names.end(),
                                     [](const std::string& name) { return !name.empty(); });
  if (params_.sensor_name.empty() && !has_names) {
    RCLCPP_ERROR(logger,
                 "'sensor_name' or at least one 'interface_names.[force|torque].[x|y|z]' parameter "
                 "has to be specified.");
    return false;
  }
  if (!params_.sensor_name.empty() && has_names) {
    RCLCPP_ERROR(logger,
                 "both 'sensor_name' and 'interface_names.[force|torque].[x|y|z]' parameters can "
                 "not be specified together.");
    return false;
  }
  sensor_ = has_names
                ? std::make_unique<semantic_components::ForceTorqueSensor>(
                      names[0], names[1], names[2], names[3], names[4], names[5])
                : std::make_unique<semantic_components::ForceTorqueSensor>(params_.sensor_name);
  return true;
}

CallbackReturn ForceTorqueSensorBroadcaster::on_configure(const rclcpp_lifecycle::State&) {
  params_ = param_listener_->get_params();
  if (!choose_sensor()) return CallbackReturn::ERROR;
  if (has_filters()) {
    RCLCPP_ERROR(get_node()->get_logger(),
                 "'sensor_filter_chain' is not supported in a site: remove it and filter the topic "
                 "~/wrench in a node");
    return CallbackReturn::ERROR;
  }
  realtime_publisher_ = std::make_unique<realtime_tools::RealtimePublisher<Message>>(
      get_node()->create_publisher<Message>("~/wrench", rclcpp::SystemDefaultsQoS()));
  message_.header.frame_id = params_.frame_id;
  RCLCPP_INFO(get_node()->get_logger(), "configure successful");
  return CallbackReturn::SUCCESS;
}

InterfaceConfiguration ForceTorqueSensorBroadcaster::command_interface_configuration() const {
  return {interface_configuration_type::NONE, {}};
}

InterfaceConfiguration ForceTorqueSensorBroadcaster::state_interface_configuration() const {
  return {interface_configuration_type::INDIVIDUAL, sensor_->get_state_interface_names()};
}

CallbackReturn ForceTorqueSensorBroadcaster::on_activate(const rclcpp_lifecycle::State&) {
  sensor_->assign_loaned_state_interfaces(state_interfaces_);
  return CallbackReturn::SUCCESS;
}

CallbackReturn ForceTorqueSensorBroadcaster::on_deactivate(const rclcpp_lifecycle::State&) {
  sensor_->release_interfaces();
  return CallbackReturn::SUCCESS;
}

return_type ForceTorqueSensorBroadcaster::update_reference_from_subscribers(
    const rclcpp::Time&, const rclcpp::Duration&) {
  return return_type::OK;
}

return_type ForceTorqueSensorBroadcaster::update_and_write_commands(const rclcpp::Time& time,
                                                                    const rclcpp::Duration&) {
  param_listener_->try_update_params(params_);
  message_.header.stamp = time;
  sensor_->get_values_as_message(message_.wrench);
  const auto values = values_of(message_.wrench);
  size_t exported = 0;
  for (size_t i = 0; i < kAxes; ++i) {
    *values[i] = (*values[i] + params_.offset[i]) * params_.multiplier[i];
    const bool is_exported = !params_.sensor_name.empty() || !params_.interface_names[i].empty();
    if (!is_exported || exported >= ordered_exported_state_interfaces_.size()) continue;
    if (!ordered_exported_state_interfaces_[exported++]->set_value(*values[i])) {
      RCLCPP_DEBUG(get_node()->get_logger(), "Unable to export %s", kAxisNames[i]);
    }
  }
  if (realtime_publisher_) realtime_publisher_->try_publish(message_);
  return return_type::OK;
}

std::vector<hardware_interface::StateInterface::SharedPtr>
ForceTorqueSensorBroadcaster::on_export_state_interfaces_list() {
  const std::string name = get_node()->get_name();
  std::vector<hardware_interface::StateInterface::SharedPtr> exported;
  for (size_t i = 0; i < kAxes; ++i) {
    if (!params_.sensor_name.empty()) {
      exported.push_back(std::make_shared<hardware_interface::StateInterface>(
          name + "/" + params_.sensor_name, kAxisNames[i]));
    } else if (!params_.interface_names[i].empty()) {
      exported.push_back(
          std::make_shared<hardware_interface::StateInterface>(name, params_.interface_names[i]));
    }
  }
  return exported;
}

}  // namespace force_torque_sensor_broadcaster

PLUGINLIB_EXPORT_CLASS(force_torque_sensor_broadcaster::ForceTorqueSensorBroadcaster,
                       controller_interface::ChainableControllerInterface)
