// Publishes the values of an IMU.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "controller_interface/controller_interface.hpp"
#include "rclcpp_lifecycle/state.hpp"
#include "realtime_tools/realtime_publisher.hpp"
#include "ros2wasm_parameters/parameters.hpp"
#include "semantic_components/imu_sensor.hpp"
#include "sensor_msgs/msg/imu.hpp"

namespace imu_sensor_broadcaster {

struct Params {
  std::string sensor_name;
  std::string frame_id;
  /// Row major about x, y, z.
  std::vector<double> static_covariance_orientation = std::vector<double>(9, 0.0);
  std::vector<double> static_covariance_angular_velocity = std::vector<double>(9, 0.0);
  std::vector<double> static_covariance_linear_acceleration = std::vector<double>(9, 0.0);
};

class IMUSensorBroadcaster : public controller_interface::ControllerInterface {
 public:
  controller_interface::InterfaceConfiguration command_interface_configuration() const override;
  controller_interface::InterfaceConfiguration state_interface_configuration() const override;
  controller_interface::CallbackReturn on_init() override;
  controller_interface::CallbackReturn on_configure(
      const rclcpp_lifecycle::State& previous_state) override;
  controller_interface::CallbackReturn on_activate(
      const rclcpp_lifecycle::State& previous_state) override;
  controller_interface::CallbackReturn on_deactivate(
      const rclcpp_lifecycle::State& previous_state) override;
  controller_interface::return_type update(const rclcpp::Time& time,
                                           const rclcpp::Duration& period) override;

 protected:
  using Message = sensor_msgs::msg::Imu;
  using ParamListener = ros2wasm_parameters::ParameterListener<Params>;

  std::shared_ptr<ParamListener> param_listener_;
  Params params_;
  std::unique_ptr<semantic_components::IMUSensor> sensor_;
  Message message_;
  std::unique_ptr<realtime_tools::RealtimePublisher<Message>> realtime_publisher_;
};

}  // namespace imu_sensor_broadcaster
