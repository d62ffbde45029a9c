// The node of a controller, its transitions and its rate.
#include "controller_interface/controller_interface_base.hpp"

#include <atomic>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "rclcpp/utilities.hpp"

namespace controller_interface {

using lifecycle_msgs::msg::State;

struct ControllerInterfaceBase::Parts {
  std::shared_ptr<rclcpp_lifecycle::LifecycleNode> node;
  ControllerInterfaceParams params;
  bool is_async = false;
};

ControllerInterfaceBase::ControllerInterfaceBase() : parts_(std::make_unique<Parts>()) {}

ControllerInterfaceBase::~ControllerInterfaceBase() {
  // A node that is shut down here would call callbacks of an object that is half gone: those of
  // this class only, as in ROS 2.
  if (parts_->node && get_lifecycle_id() != State::PRIMARY_STATE_FINALIZED && rclcpp::ok()) {
    parts_->node->shutdown();
  }
}

return_type ControllerInterfaceBase::init(const std::string& controller_name,
                                          const std::string& urdf, unsigned int cm_update_rate,
                                          const std::string& node_namespace,
                                          const rclcpp::NodeOptions& node_options) {
  ControllerInterfaceParams params;
  params.controller_name = controller_name;
  params.robot_description = urdf;
  params.update_rate = params.controller_manager_update_rate = cm_update_rate;
  params.node_namespace = node_namespace;
  params.node_options = node_options;
  return init(params);
}

return_type ControllerInterfaceBase::init(const ControllerInterfaceParams& params) {
  parts_->params = params;
  if (params.controller_manager_update_rate == 0) {
    parts_->params.controller_manager_update_rate = params.update_rate;
  }
  parts_->node = std::make_shared<rclcpp_lifecycle::LifecycleNode>(
      params.controller_name, params.node_namespace, params.node_options, false);
  try {
    auto_declare<int>("update_rate",
                      static_cast<int>(parts_->params.controller_manager_update_rate));
    auto_declare<bool>("is_async", false);
    auto_declare<int>("thread_priority", -100);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "Exception thrown during init stage with message: %s \n", error.what());
    return return_type::ERROR;
  }
  register_transitions();
  if (on_init() == CallbackReturn::SUCCESS) {
    return return_type::OK;
  }
  RCLCPP_ERROR(get_node()->get_logger(),
               "Calling shutdown transition of controller node '%s' due to init failure.",
               get_node()->get_name());
  parts_->node->shutdown();
  return return_type::ERROR;
}

void ControllerInterfaceBase::register_transitions() {
  auto& node = *parts_->node;
  using Before = rclcpp_lifecycle::State;
  node.register_on_configure([this](const Before& before) { return on_configure(before); });
  node.register_on_cleanup([this](const Before& before) { return on_cleanup(before); });
  node.register_on_activate([this](const Before& before) { return on_activate(before); });
  node.register_on_deactivate([this](const Before& before) { return on_deactivate(before); });
  node.register_on_shutdown([this](const Before& before) {
    const CallbackReturn result = on_shutdown(before);
    release_interfaces();
    return result;
  });
  node.register_on_error([this](const Before& before) {
    const CallbackReturn result = on_error(before);
    release_interfaces();
    return result;
  });
}

void ControllerInterfaceBase::choose_update_rate() {
  ControllerInterfaceParams& params = parts_->params;
  const unsigned int manager_rate = params.controller_manager_update_rate;
  const auto rate = static_cast<unsigned int>(get_node()->get_parameter("update_rate").as_int());
  if (params.update_rate != 0 && rate > params.update_rate) {
    RCLCPP_WARN(get_node()->get_logger(),
                "The update rate of the controller : '%u Hz' cannot be higher than the update rate "
                "of the controller manager : '%u Hz'. Setting it to the update rate of the "
                "controller manager.",
                rate, params.update_rate);
    return;
  }
  if (rate == 0 || manager_rate == 0) {
    return;
  }
  params.update_rate = rate;
  if (manager_rate % rate != 0) {
    const double cycles = std::round(static_cast<double>(manager_rate) / rate);
    params.update_rate = manager_rate / static_cast<unsigned int>(cycles);
    RCLCPP_WARN(
        get_node()->get_logger(),
        "The requested update rate of '%u' Hz is not achievable with the controller manager "
        "update rate of '%u' Hz. Setting it to the closest achievable frequency '%u' Hz.",
        rate, manager_rate, params.update_rate);
  }
}

const rclcpp_lifecycle::State& ControllerInterfaceBase::configure() {
  if (get_lifecycle_id() == State::PRIMARY_STATE_UNCONFIGURED) {
    if (get_node()->get_parameter("update_rate").as_int() < 0) {
      RCLCPP_ERROR(get_node()->get_logger(), "Update rate cannot be a negative value!");
      return get_lifecycle_state();
    }
    choose_update_rate();
    parts_->is_async = get_node()->get_parameter("is_async").as_bool();
    if (parts_->is_async) {
      RCLCPP_WARN(get_node()->get_logger(),
                  "The parameter 'is_async' has no effect in a site: the controller is updated by "
                  "the control loop.");
    }
  }
  return get_node()->configure();
}

void ControllerInterfaceBase::assign_interfaces(
    std::vector<hardware_interface::LoanedCommandInterface>&& command_interfaces,
    std::vector<hardware_interface::LoanedStateInterface>&& state_interfaces) {
  command_interfaces_.swap(command_interfaces);
  state_interfaces_.swap(state_interfaces);
}

void ControllerInterfaceBase::release_interfaces() {
  command_interfaces_.clear();
  state_interfaces_.clear();
}

ControllerUpdateStatus ControllerInterfaceBase::trigger_update(const rclcpp::Time& time,
                                                               const rclcpp::Duration& period) {
  ControllerUpdateStatus status;
  status.result = update(time, period);
  status.period = period;
  return status;
}

std::shared_ptr<rclcpp_lifecycle::LifecycleNode> ControllerInterfaceBase::get_node() {
  if (!parts_->node) {
    throw std::runtime_error("Lifecycle node hasn't been initialized yet!");
  }
  return parts_->node;
}
std::shared_ptr<const rclcpp_lifecycle::LifecycleNode> ControllerInterfaceBase::get_node() const {
  return const_cast<ControllerInterfaceBase*>(this)->get_node();
}
const rclcpp_lifecycle::State& ControllerInterfaceBase::get_lifecycle_state() const {
  return get_node()->get_current_state();
}
uint8_t ControllerInterfaceBase::get_lifecycle_id() const {
  return get_lifecycle_state().id();
}
unsigned int ControllerInterfaceBase::get_update_rate() const {
  return parts_->params.update_rate;
}
bool ControllerInterfaceBase::is_async() const {
  return parts_->is_async;
}
const std::string& ControllerInterfaceBase::get_robot_description() const {
  return parts_->params.robot_description;
}
const std::unordered_map<std::string, joint_limits::JointLimits>&
ControllerInterfaceBase::get_hard_joint_limits() const {
  return parts_->params.hard_joint_limits;
}
const std::unordered_map<std::string, joint_limits::SoftJointLimits>&
ControllerInterfaceBase::get_soft_joint_limits() const {
  return parts_->params.soft_joint_limits;
}
std::string ControllerInterfaceBase::get_name() const {
  return get_node()->get_name();
}

}  // namespace controller_interface
