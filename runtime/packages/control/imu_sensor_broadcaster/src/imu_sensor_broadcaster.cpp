// See imu_sensor_broadcaster.hpp.
#include "imu_sensor_broadcaster/imu_sensor_broadcaster.hpp"

#include <algorithm>
#include <exception>

#include "pluginlib/class_list_macros.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/qos.hpp"

namespace imu_sensor_broadcaster {
namespace {

using ros2wasm_parameters::fixed_size;
using ros2wasm_parameters::not_empty;
using Covariance = std::vector<double>;

void describe(ros2wasm_parameters::Declarations& of, Params& params) {
  of.add("sensor_name", params.sensor_name, {"Name of the sensor, before its interfaces."},
         {not_empty<std::string>()});
  of.add("frame_id", params.frame_id, {"The frame of the values."}, {not_empty<std::string>()});
  of.add("static_covariance_orientation", params.static_covariance_orientation,
         {"Covariance of the orientation, row major about x, y, z."}, {fixed_size<Covariance>(9)});
  of.add("static_covariance_angular_velocity", params.static_covariance_angular_velocity,
         {"Covariance of the angular velocity, row major about x, y, z."},
         {fixed_size<Covariance>(9)});
  of.add("static_covariance_linear_acceleration", params.static_covariance_linear_acceleration,
         {"Covariance of the linear acceleration, row major about x, y, z."},
         {fixed_size<Covariance>(9)});
}

}  // namespace

using controller_interface::CallbackReturn;
using controller_interface::interface_configuration_type;
using controller_interface::InterfaceConfiguration;
using controller_interface::return_type;

CallbackReturn IMUSensorBroadcaster::on_init() {
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

CallbackReturn IMUSensorBroadcaster::on_configure(const rclcpp_lifecycle::State&) {
  params_ = param_listener_->get_params();
  sensor_ = std::make_unique<semantic_components::IMUSensor>(params_.sensor_name);
  realtime_publisher_ = std::make_unique<realtime_tools::RealtimePublisher<Message>>(
      get_node()->create_publisher<Message>("~/imu", rclcpp::SystemDefaultsQoS()));
  message_.header.frame_id = params_.frame_id;
  const auto copy = [](const std::vector<double>& from, auto& to) {
    std::copy(from.begin(), from.end(), to.begin());
  };
  copy(params_.static_covariance_orientation, message_.orientation_covariance);
  copy(params_.static_covariance_angular_velocity, message_.angular_velocity_covariance);
  copy(params_.static_covariance_linear_acceleration, message_.linear_acceleration_covariance);
  RCLCPP_DEBUG(get_node()->get_logger(), "configure successful");
  return CallbackReturn::SUCCESS;
}

InterfaceConfiguration IMUSensorBroadcaster::command_interface_configuration() const {
  return {interface_configuration_type::NONE, {}};
}

InterfaceConfiguration IMUSensorBroadcaster::state_interface_configuration() const {
  return {interface_configuration_type::INDIVIDUAL, sensor_->get_state_interface_names()};
}

CallbackReturn IMUSensorBroadcaster::on_activate(const rclcpp_lifecycle::State&) {
  sensor_->assign_loaned_state_interfaces(state_interfaces_);
  return CallbackReturn::SUCCESS;
}

CallbackReturn IMUSensorBroadcaster::on_deactivate(const rclcpp_lifecycle::State&) {
  sensor_->release_interfaces();
  return CallbackReturn::SUCCESS;
}

return_type IMUSensorBroadcaster::update(const rclcpp::Time& time, const rclcpp::Duration&) {
  if (realtime_publisher_) {
    message_.header.stamp = time;
    sensor_->get_values_as_message(message_);
    realtime_publisher_->try_publish(message_);
  }
  return return_type::OK;
}

}  // namespace imu_sensor_broadcaster

PLUGINLIB_EXPORT_CLASS(imu_sensor_broadcaster::IMUSensorBroadcaster,
                       controller_interface::ControllerInterface)
