// Publishes the values of a force torque sensor, and exports them to other controllers.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "controller_interface/chainable_controller_interface.hpp"
#include "geometry_msgs/msg/wrench_stamped.hpp"
#include "rclcpp_lifecycle/state.hpp"
#include "realtime_tools/realtime_publisher.hpp"
#include "ros2wasm_parameters/parameters.hpp"
#include "semantic_components/force_torque_sensor.hpp"

namespace force_torque_sensor_broadcaster {

/// force.x, force.y, force.z, torque.x, torque.y, torque.z
constexpr size_t kAxes = 6;

struct Params {
  std::string frame_id;
  std::string sensor_name;
  std::array<std::string, kAxes> interface_names;
  std::array<double, kAxes> offset = {};
  std::array<double, kAxes> multiplier = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
};

class ForceTorqueSensorBroadcaster : public controller_interface::ChainableControllerInterface {
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
  controller_interface::return_type update_and_write_commands(
      const rclcpp::Time& time, const rclcpp::Duration& period) override;
  controller_interface::return_type update_reference_from_subscribers(
      const rclcpp::Time& time, const rclcpp::Duration& period) override;

 protected:
  std::vector<hardware_interface::StateInterface::SharedPtr> on_export_state_interfaces_list()
      override;

  using ParamListener = ros2wasm_parameters::ParameterListener<Params>;
  using Message = geometry_msgs::msg::WrenchStamped;

  std::shared_ptr<ParamListener> param_listener_;
  Params params_;
  std::unique_ptr<semantic_components::ForceTorqueSensor> sensor_;
  Message message_;
  std::unique_ptr<realtime_tools::RealtimePublisher<Message>> realtime_publisher_;

 private:
  bool has_filters();
  bool choose_sensor();
};

}  // namespace force_torque_sensor_broadcaster
