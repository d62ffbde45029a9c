// See range_sensor_broadcaster.hpp.
#include "range_sensor_broadcaster/range_sensor_broadcaster.hpp"

#include <exception>

#include "pluginlib/class_list_macros.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/qos.hpp"

namespace range_sensor_broadcaster {
namespace {

void describe(ros2wasm_parameters::Declarations& of, Params& params) {
  of.add("sensor_name", params.sensor_name, {"Name of the sensor, before its interface."});
  of.add("frame_id", params.frame_id, {"The frame of the values."});
  of.add("radiation_type", params.radiation_type, {"0: ultrasound, 1: infrared"});
  of.add("field_of_view", params.field_of_view, {"Angle that the distance is valid for [rad]"});
  of.add("min_range", params.min_range, {"Shortest distance [m]"});
  of.add("max_range", params.max_range, {"Longest distance [m]"});
  of.add("variance", params.variance, {"Variance of the distance"});
}

}  // namespace

using controller_interface::CallbackReturn;
using controller_interface::interface_configuration_type;
using controller_interface::InterfaceConfiguration;
using controller_interface::return_type;

CallbackReturn RangeSensorBroadcaster::on_init() {
  try {
    param_listener_ = std::make_shared<ParamListener>(get_node(), describe);
    params_ = param_listener_->get_params();
  } catch (const std::exception& error) {
    RCLCPP_ERROR(get_node()->get_logger(), "Exception thrown during init stage with message: %s \n",
                 error.what());
    return CallbackReturn::ERROR;
  }
  return CallbackReturn::SUCCESS;
}

CallbackReturn RangeSensorBroadcaster::on_configure(const rclcpp_lifecycle::State&) {
  params_ = param_listener_->get_params();
  if (params_.sensor_name.empty()) {
    RCLCPP_ERROR(get_node()->get_logger(), "'sensor_name' parameter has to be specified.");
    return CallbackReturn::ERROR;
  }
  if (params_.frame_id.empty()) {
    RCLCPP_ERROR(get_node()->get_logger(), "'frame_id' parameter has to be provided.");
    return CallbackReturn::ERROR;
  }
  sensor_ = std::make_unique<semantic_components::RangeSensor>(params_.sensor_name);
  realtime_publisher_ = std::make_unique<realtime_tools::RealtimePublisher<Message>>(
      get_node()->create_publisher<Message>("~/range", rclcpp::SystemDefaultsQoS()));
  message_.header.frame_id = params_.frame_id;
  message_.radiation_type = static_cast<uint8_t>(params_.radiation_type);
  message_.field_of_view = static_cast<float>(params_.field_of_view);
  message_.min_range = static_cast<float>(params_.min_range);
  message_.max_range = static_cast<float>(params_.max_range);
  message_.variance = static_cast<float>(params_.variance);
  RCLCPP_DEBUG(get_node()->get_logger(), "configure successful");
  return CallbackReturn::SUCCESS;
}

InterfaceConfiguration RangeSensorBroadcaster::command_interface_configuration() const {
  return {interface_configuration_type::NONE, {}};
}

InterfaceConfiguration RangeSensorBroadcaster::state_interface_configuration() const {
  return {interface_configuration_type::INDIVIDUAL, sensor_->get_state_interface_names()};
}

CallbackReturn RangeSensorBroadcaster::on_activate(const rclcpp_lifecycle::State&) {
  sensor_->assign_loaned_state_interfaces(state_interfaces_);
  return CallbackReturn::SUCCESS;
}

CallbackReturn RangeSensorBroadcaster::on_deactivate(const rclcpp_lifecycle::State&) {
  sensor_->release_interfaces();
  return CallbackReturn::SUCCESS;
}

return_type RangeSensorBroadcaster::update(const rclcpp::Time& time, const rclcpp::Duration&) {
  if (realtime_publisher_) {
    message_.header.stamp = time;
    sensor_->get_values_as_message(message_);
    realtime_publisher_->try_publish(message_);
  }
  return return_type::OK;
}

}  // namespace range_sensor_broadcaster

PLUGINLIB_EXPORT_CLASS(range_sensor_broadcaster::RangeSensorBroadcaster,
                       controller_interface::ControllerInterface)
