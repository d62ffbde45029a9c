// Publishes state interfaces as joint_states and dynamic_joint_states.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "control_msgs/msg/dynamic_joint_state.hpp"
#include "controller_interface/controller_interface.hpp"
#include "joint_state_broadcaster/joint_data.hpp"
#include "rclcpp_lifecycle/state.hpp"
#include "realtime_tools/realtime_publisher.hpp"
#include "ros2wasm_parameters/parameters.hpp"
#include "sensor_msgs/msg/joint_state.hpp"
#include "urdf/model.h"

namespace joint_state_broadcaster {

struct Params {
  bool use_local_topics = false;
  std::vector<std::string> joints;
  std::vector<std::string> extra_joints;
  std::vector<std::string> interfaces;
  struct MapInterfaceToJointState {
    std::string position = "position";
    std::string velocity = "velocity";
    std::string effort = "effort";
  } map_interface_to_joint_state;
  bool use_urdf_to_filter = true;
  std::string frame_id = "base_link";
  bool publish_dynamic_joint_states = true;
};

class JointStateBroadcaster : public controller_interface::ControllerInterface {
 public:
  JointStateBroadcaster() = default;

  controller_interface::InterfaceConfiguration command_interface_configuration() const override;
  controller_interface::InterfaceConfiguration state_interface_configuration() const override;
  controller_interface::return_type update(const rclcpp::Time& time,
                                           const rclcpp::Duration& period) override;
  controller_interface::CallbackReturn on_init() override;
  controller_interface::CallbackReturn on_configure(
      const rclcpp_lifecycle::State& previous_state) override;
  controller_interface::CallbackReturn on_activate(
      const rclcpp_lifecycle::State& previous_state) override;
  controller_interface::CallbackReturn on_deactivate(
      const rclcpp_lifecycle::State& previous_state) override;

 protected:
  bool use_all_available_interfaces() const;
  bool init_joint_data();
  void init_messages();

  using ParamListener = ros2wasm_parameters::ParameterListener<Params>;
  using JointState = sensor_msgs::msg::JointState;
  using DynamicJointState = control_msgs::msg::DynamicJointState;

  std::shared_ptr<ParamListener> param_listener_;
  Params params_;
  std::map<std::string, std::string> map_interface_to_joint_state_;
  JointData joint_data_;
  std::vector<size_t> published_;  ///< places in state_interfaces_ of those with doubles
  urdf::Model model_;
  bool is_model_loaded_ = false;
  JointState joint_state_msg_;
  DynamicJointState dynamic_joint_state_msg_;
  std::shared_ptr<realtime_tools::RealtimePublisher<JointState>> realtime_joint_state_publisher_;
  std::shared_ptr<realtime_tools::RealtimePublisher<DynamicJointState>>
      realtime_dynamic_joint_state_publisher_;

 private:
  void map_interface(const std::string& standard, const std::string& interface);
  void create_publishers();
  void load_model();
};

}  // namespace joint_state_broadcaster
