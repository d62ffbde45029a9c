// See joint_state_broadcaster.hpp.
#include "joint_state_broadcaster/joint_state_broadcaster.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <limits>

#include "hardware_interface/types/hardware_interface_type_values.hpp"
#include "pluginlib/class_list_macros.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/qos.hpp"

namespace joint_state_broadcaster {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

void describe(ros2wasm_parameters::Declarations& of, Params& params) {
  using ros2wasm_parameters::kReadOnly;
  of.add("use_local_topics", params.use_local_topics,
         {"Publish the topics in the namespace of the broadcaster?", kReadOnly});
  of.add("joints", params.joints,
         {"Joints to publish, together with 'interfaces'. When either is empty, all state "
          "interfaces are published.",
          kReadOnly});
  of.add("extra_joints", params.extra_joints,
         {"More joints for joint_states, whose values are 0.", kReadOnly});
  of.add("interfaces", params.interfaces,
         {"Interfaces to publish, together with 'joints'.", kReadOnly});
  auto& map = params.map_interface_to_joint_state;
  of.add("map_interface_to_joint_state.position", map.position, {"", kReadOnly});
  of.add("map_interface_to_joint_state.velocity", map.velocity, {"", kReadOnly});
  of.add("map_interface_to_joint_state.effort", map.effort, {"", kReadOnly});
  of.add("use_urdf_to_filter", params.use_urdf_to_filter,
         {"Publish in joint_states only joints of the robot description?", kReadOnly});
  of.add("frame_id", params.frame_id, {"The frame of joint_states.", kReadOnly});
  of.add("publish_dynamic_joint_states", params.publish_dynamic_joint_states,
         {"Publish dynamic_joint_states as well?", kReadOnly});
}

}  // namespace

using controller_interface::CallbackReturn;
using controller_interface::interface_configuration_type;
using controller_interface::InterfaceConfiguration;
using controller_interface::return_type;
using hardware_interface::HW_IF_EFFORT;
using hardware_interface::HW_IF_POSITION;
using hardware_interface::HW_IF_VELOCITY;

CallbackReturn JointStateBroadcaster::on_init() {
  try {
    param_listener_ = std::make_shared<ParamListener>(get_node(), describe);
    params_ = param_listener_->get_params();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "Exception thrown during init stage with message: %s \n", error.what());
    return CallbackReturn::ERROR;
  }
  return CallbackReturn::SUCCESS;
}

InterfaceConfiguration JointStateBroadcaster::command_interface_configuration() const {
  return {interface_configuration_type::NONE, {}};
}

InterfaceConfiguration JointStateBroadcaster::state_interface_configuration() const {
  if (use_all_available_interfaces()) return {interface_configuration_type::ALL, {}};
  InterfaceConfiguration wanted{interface_configuration_type::INDIVIDUAL, {}};
  for (const std::string& joint : params_.joints) {
    for (const std::string& interface : params_.interfaces) {
      wanted.names.push_back(joint + "/" + interface);
    }
  }
  return wanted;
}

bool JointStateBroadcaster::use_all_available_interfaces() const {
  return params_.joints.empty() || params_.interfaces.empty();
}

CallbackReturn JointStateBroadcaster::on_configure(const rclcpp_lifecycle::State&) {
  params_ = param_listener_->get_params();
  const auto logger = get_node()->get_logger();
  if (use_all_available_interfaces()) {
    RCLCPP_INFO(logger,
                "'joints' or 'interfaces' parameter is empty. "
                "All available state interfaces will be published");
    params_.joints.clear();
    params_.interfaces.clear();
  } else {
    RCLCPP_INFO(logger,
                "Publishing state interfaces defined in 'joints' and 'interfaces' parameters.");
  }
  map_interface_to_joint_state_.clear();
  map_interface(HW_IF_POSITION, params_.map_interface_to_joint_state.position);
  map_interface(HW_IF_VELOCITY, params_.map_interface_to_joint_state.velocity);
  map_interface(HW_IF_EFFORT, params_.map_interface_to_joint_state.effort);
  try {
    create_publishers();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "Exception thrown during init stage with message: %s \n", error.what());
    return CallbackReturn::ERROR;
  }
  load_model();
  if (params_.frame_id.empty()) RCLCPP_WARN(logger, "Frame ID is not set.");
  return CallbackReturn::SUCCESS;
}

void JointStateBroadcaster::map_interface(const std::string& standard,
                                          const std::string& interface) {
  const auto& given = params_.interfaces;
  if (std::find(given.begin(), given.end(), standard) == given.end()) {
    map_interface_to_joint_state_[interface] = standard;
    return;
  }
  map_interface_to_joint_state_[standard] = standard;
  if (standard != interface) {
    RCLCPP_WARN(get_node()->get_logger(),
                "Mapping from '%s' to interface '%s' will not be done, because '%s' is defined "
                "in 'interface' parameter.",
                interface.c_str(), standard.c_str(), standard.c_str());
  }
}

void JointStateBroadcaster::create_publishers() {
  const std::string prefix = params_.use_local_topics ? "~/" : "";
  realtime_joint_state_publisher_ = std::make_shared<realtime_tools::RealtimePublisher<JointState>>(
      get_node()->create_publisher<JointState>(prefix + "joint_states",
                                               rclcpp::SystemDefaultsQoS()));
  if (!params_.publish_dynamic_joint_states) return;
  realtime_dynamic_joint_state_publisher_ =
      std::make_shared<realtime_tools::RealtimePublisher<DynamicJointState>>(
          get_node()->create_publisher<DynamicJointState>(prefix + "dynamic_joint_states",
                                                          rclcpp::SystemDefaultsQoS()));
}

void JointStateBroadcaster::load_model() {
  const std::string& description = get_robot_description();
  is_model_loaded_ = !description.empty() && model_.initString(description);
  if (is_model_loaded_) return;
  RCLCPP_ERROR(get_node()->get_logger(),
               "Failed to parse robot description. Will publish all the interfaces with '%s', "
               "'%s' and '%s'",
               HW_IF_POSITION, HW_IF_VELOCITY, HW_IF_EFFORT);
}

CallbackReturn JointStateBroadcaster::on_activate(const rclcpp_lifecycle::State&) {
  if (!init_joint_data()) {
    RCLCPP_ERROR(get_node()->get_logger(),
                 "Error initializing joint data. JointStateBroadcaster will not run.");
    return CallbackReturn::ERROR;
  }
  init_messages();
  return CallbackReturn::SUCCESS;
}

CallbackReturn JointStateBroadcaster::on_deactivate(const rclcpp_lifecycle::State&) {
  joint_data_ = JointData();
  published_.clear();
  return CallbackReturn::SUCCESS;
}

bool JointStateBroadcaster::init_joint_data() {
  if (state_interfaces_.empty()) {
    RCLCPP_ERROR(get_node()->get_logger(), "No state interfaces found to publish.");
    return false;
  }
  published_.clear();
  std::vector<JointInterface> interfaces;
  for (size_t i = 0; i < state_interfaces_.size(); ++i) {
    const auto& state = state_interfaces_[i];
    if (state.get_data_type() == hardware_interface::HandleDataType::DOUBLE) {
      published_.push_back(i);
      interfaces.push_back({state.get_prefix_name(), state.get_interface_name()});
      continue;
    }
    RCLCPP_WARN(get_node()->get_logger(),
                "State interface '%s' of joint '%s' has non-double data type and will be ignored.",
                state.get_interface_name().c_str(), state.get_prefix_name().c_str());
  }
  JointDataOptions options;
  options.standard_names = map_interface_to_joint_state_;
  options.extra_joints = params_.extra_joints;
  options.filters_by_model =
      is_model_loaded_ && params_.use_urdf_to_filter && params_.joints.empty();
  for (const auto& [name, joint] : model_.joints_) {
    if (joint && joint->type != urdf::Joint::FIXED) options.model_joints.push_back(name);
  }
  joint_data_ = JointData(interfaces, options);
  return true;
}

void JointStateBroadcaster::init_messages() {
  const std::vector<std::string>& names = joint_data_.names();
  joint_state_msg_.header.frame_id = params_.frame_id;
  joint_state_msg_.name = names;
  joint_state_msg_.position.assign(names.size(), kNotANumber);
  joint_state_msg_.velocity.assign(names.size(), kNotANumber);
  joint_state_msg_.effort.assign(names.size(), kNotANumber);

  dynamic_joint_state_msg_.header.frame_id = params_.frame_id;
  dynamic_joint_state_msg_.joint_names.clear();
  dynamic_joint_state_msg_.interface_values.clear();
  for (const auto& [joint, values] : joint_data_.all()) {
    control_msgs::msg::InterfaceValue of_joint;
    for (const auto& [interface, value] : values) {
      of_joint.interface_names.push_back(interface);
      of_joint.values.push_back(value);
    }
    dynamic_joint_state_msg_.joint_names.push_back(joint);
    dynamic_joint_state_msg_.interface_values.push_back(of_joint);
  }
}

return_type JointStateBroadcaster::update(const rclcpp::Time& time, const rclcpp::Duration&) {
  for (size_t i = 0; i < published_.size(); ++i) {
    // An interface that is busy keeps its last value.
    const auto value = state_interfaces_[published_[i]].get_optional(1);
    if (value) joint_data_.set(i, *value);
  }
  if (realtime_joint_state_publisher_) {
    joint_state_msg_.header.stamp = time;
    for (size_t i = 0; i < joint_state_msg_.name.size(); ++i) {
      const std::string& joint = joint_state_msg_.name[i];
      joint_state_msg_.position[i] = joint_data_.value(joint, HW_IF_POSITION);
      joint_state_msg_.velocity[i] = joint_data_.value(joint, HW_IF_VELOCITY);
      joint_state_msg_.effort[i] = joint_data_.value(joint, HW_IF_EFFORT);
    }
    realtime_joint_state_publisher_->try_publish(joint_state_msg_);
  }
  if (realtime_dynamic_joint_state_publisher_) {
    dynamic_joint_state_msg_.header.stamp = time;
    size_t place = 0;
    for (const auto& joint : joint_data_.all()) {
      auto& values = dynamic_joint_state_msg_.interface_values[place++].values;
      size_t at = 0;
      for (const auto& interface : joint.second) values[at++] = interface.second;
    }
    realtime_dynamic_joint_state_publisher_->try_publish(dynamic_joint_state_msg_);
  }
  return return_type::OK;
}

}  // namespace joint_state_broadcaster

PLUGINLIB_EXPORT_CLASS(joint_state_broadcaster::JointStateBroadcaster,
                       controller_interface::ControllerInterface)
