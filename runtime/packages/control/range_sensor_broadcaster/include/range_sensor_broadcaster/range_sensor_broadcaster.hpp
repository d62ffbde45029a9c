// Publishes a measured distance.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "controller_interface/controller_interface.hpp"
#include "rclcpp_lifecycle/state.hpp"
#include "realtime_tools/realtime_publisher.hpp"
#include "ros2wasm_parameters/parameters.hpp"
#include "semantic_components/range_sensor.hpp"
#include "sensor_msgs/msg/range.hpp"

namespace range_sensor_broadcaster {

struct Params {
  std::string sensor_name;
  std::string frame_id;
  int64_t radiation_type = 0;
  double field_of_view = 0.52;
  double min_range = 0.52;
  double max_range = 4.0;
  double variance = 0.0;
};

class RangeSensorBroadcaster : public controller_interface::ControllerInterface {
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
  using Message = sensor_msgs::msg::Range;
  using ParamListener = ros2wasm_parameters::ParameterListener<Params>;

  std::shared_ptr<ParamListener> param_listener_;
  Params params_;
  std::unique_ptr<semantic_components::RangeSensor> sensor_;
  Message message_;
  std::unique_ptr<realtime_tools::RealtimePublisher<Message>> realtime_publisher_;
};

}  // namespace range_sensor_broadcaster
