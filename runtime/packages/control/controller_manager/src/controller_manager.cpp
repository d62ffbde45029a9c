// The start of the manager: parameters, robot description and hardware.
#include "controller_manager/controller_manager.hpp"

#include <chrono>
#include <stdexcept>
#include <utility>

#include "hardware_interface/helpers.hpp"
#include "manager_services.hpp"
#include "rclcpp/utilities.hpp"
#include "switch_plan.hpp"

namespace controller_manager {

using hardware_interface::ResourceManager;
using lifecycle_msgs::msg::State;

namespace {

/// The value of a parameter, which is declared when nobody has set it.
template <typename T>
T declared(rclcpp::Node& node, const std::string& name, const T& otherwise, bool read_only) {
  if (!node.has_parameter(name)) {
    rcl_interfaces::msg::ParameterDescriptor descriptor;
    descriptor.read_only = read_only;
    node.declare_parameter<T>(name, otherwise, descriptor);
  }
  return node.get_parameter(name).get_value<T>();
}

}  // namespace

rclcpp::NodeOptions get_cm_node_options() {
  rclcpp::NodeOptions options;
  // Parameters of controllers are set here before the controllers exist.
  options.allow_undeclared_parameters(true);
  options.automatically_declare_parameters_from_overrides(true);
  options.enable_logger_service(true);
  return options;
}

ControllerManager::ControllerManager(std::unique_ptr<ResourceManager> resource_manager,
                                     std::shared_ptr<rclcpp::Executor> executor,
                                     const std::string& manager_node_name,
                                     const std::string& node_namespace,
                                     const rclcpp::NodeOptions& options)
    : rclcpp::Node(manager_node_name, node_namespace, options),
      resource_manager_(std::move(resource_manager)),
      executor_(std::move(executor)),
      options_(options) {
  init_controller_manager(resource_manager_ ? resource_manager_->get_robot_description() : "");
}

ControllerManager::ControllerManager(std::shared_ptr<rclcpp::Executor> executor,
                                     const std::string& manager_node_name,
                                     const std::string& node_namespace,
                                     const rclcpp::NodeOptions& options)
    : rclcpp::Node(manager_node_name, node_namespace, options),
      executor_(std::move(executor)),
      options_(options) {
  init_controller_manager("");
}

ControllerManager::ControllerManager(std::shared_ptr<rclcpp::Executor> executor,
                                     const std::string& urdf, bool activate_all_hw_components,
                                     const std::string& manager_node_name,
                                     const std::string& node_namespace,
                                     const rclcpp::NodeOptions& options)
    : rclcpp::Node(manager_node_name, node_namespace, options),
      executor_(std::move(executor)),
      options_(options),
      activate_all_hw_components_(activate_all_hw_components) {
  init_controller_manager(urdf);
}

ControllerManager::~ControllerManager() {
  get_node_base_interface()->get_context()->remove_pre_shutdown_callback(shutdown_handle_);
}

void ControllerManager::init_controller_manager(const std::string& urdf) {
  initialize_parameters();
  services_ = std::make_unique<ManagerServices>(*this);
  if (resource_manager_) {
    resource_manager_->set_on_component_state_switch_callback([this] { publish_activity(); });
  } else {
    init_resource_manager("");
  }
  shutdown_handle_ = get_node_base_interface()->get_context()->add_pre_shutdown_callback([this] {
    RCLCPP_INFO(get_logger(), "Shutdown request received....");
    executor_->cancel();
    if (!shutdown_controllers()) {
      RCLCPP_ERROR(get_logger(), "Failed shutting down the controllers.");
    }
    if (!resource_manager_->shutdown_components()) {
      RCLCPP_ERROR(get_logger(), "Failed shutting down hardware components.");
    }
    RCLCPP_INFO(get_logger(), "Shutting down the controller manager.");
  });
  robot_description_subscription_ = create_subscription<std_msgs::msg::String>(
      "robot_description", rclcpp::QoS(1).transient_local(),
      [this](const std_msgs::msg::String& message) { robot_description_callback(message); });
  RCLCPP_INFO(get_logger(), "Subscribing to '%s' topic for robot description.",
              robot_description_subscription_->get_topic_name());
  if (is_resource_manager_initialized()) {
    robot_description_ = urdf;
    init_services();
  } else if (!urdf.empty()) {
    start_with_description(urdf);
  } else if (const std::string given = get_parameter_or<std::string>("robot_description", "");
             !given.empty()) {
    RCLCPP_WARN(get_logger(),
                "[Deprecated] Passing the robot description parameter directly to the "
                "control_manager node is deprecated. Use '~/robot_description' topic from "
                "'robot_state_publisher' instead.");
    start_with_description(given);
  }
  if (!is_resource_manager_initialized()) {
    robot_description_notification_timer_ = create_wall_timer(std::chrono::seconds(1), [this] {
      RCLCPP_WARN(get_logger(),
                  "Waiting for data on 'robot_description' topic to finish initialization");
    });
  }
}

void ControllerManager::initialize_parameters() {
  use_sim_time_ = get_parameter("use_sim_time").as_bool();
  const auto rate = declared<int64_t>(*this, "update_rate", 100, true);
  if (rate <= 0) {
    throw std::runtime_error("Parameter 'update_rate' with the value '" + std::to_string(rate) +
                             "' must be greater than '0'");
  }
  update_rate_ = static_cast<unsigned int>(rate);
  enforce_command_limits_ = declared<bool>(*this, "enforce_command_limits", false, true);
  handle_exceptions_ = declared<bool>(*this, "handle_exceptions", true, true);
  declared<bool>(*this, "overruns.print_warnings", !use_sim_time_, false);
  const std::string strictness =
      declared<std::string>(*this, "defaults.switch_controller.strictness", "best_effort", false);
  if (strictness != "strict" && strictness != "best_effort") {
    throw std::runtime_error("Parameter 'defaults.switch_controller.strictness' with the value '" +
                             strictness + "' is not in the set '{strict, best_effort}'");
  }
  trigger_clock_ = use_sim_time_ ? get_clock() : std::make_shared<rclcpp::Clock>(RCL_STEADY_TIME);
  RCLCPP_INFO(get_logger(), "Using %s clock for triggering controller manager cycles.",
              use_sim_time_ ? "ROS" : "Steady (Monotonic)");
}

void ControllerManager::robot_description_callback(const std_msgs::msg::String& msg) {
  RCLCPP_INFO(get_logger(), "Received robot description from topic.");
  if (is_resource_manager_initialized()) {
    RCLCPP_WARN(get_logger(),
                "ResourceManager has already loaded a urdf and is initialized. Ignoring attempt to "
                "reload a robot description.");
    return;
  }
  start_with_description(msg.data);
}

void ControllerManager::start_with_description(const std::string& urdf) {
  robot_description_ = urdf;
  init_resource_manager(urdf);
  if (!is_resource_manager_initialized()) {
    return;
  }
  set_initial_hardware_components_state();
  RCLCPP_INFO(get_logger(),
              "Resource Manager has been successfully initialized. Starting Controller Manager "
              "services...");
  init_services();
}

void ControllerManager::init_resource_manager(const std::string& robot_description) {
  hardware_interface::ResourceManagerParams params;
  params.robot_description = robot_description;
  params.clock = trigger_clock_;
  params.logger = get_logger();
  params.update_rate = update_rate_;
  params.executor = executor_;
  params.node_namespace = get_namespace();
  params.allow_controller_activation_with_inactive_hardware = declared<bool>(
      *this, "defaults.allow_controller_activation_with_inactive_hardware", false, false);
  params.return_failed_hardware_names_on_return_deactivate_write_cycle_ = declared<bool>(
      *this, "defaults.deactivate_controllers_on_hardware_self_deactivate", true, false);
  params.handle_exceptions = handle_exceptions_;
  if (!resource_manager_) {
    resource_manager_ = std::make_unique<ResourceManager>(params, false);
    resource_manager_->set_on_component_state_switch_callback([this] { publish_activity(); });
  }
  if (robot_description.empty()) {
    return;
  }
  try {
    if (enforce_command_limits_) {
      RCLCPP_INFO(get_logger(), "Enforcing command limits is enabled...");
      resource_manager_->import_joint_limiters(robot_description);
    } else {
      RCLCPP_INFO(get_logger(),
                  "Enforcing command limits is disabled. Command limits from URDF will be "
                  "ignored.");
    }
    if (!resource_manager_->load_and_initialize_components(params)) {
      RCLCPP_WARN(get_logger(),
                  "Could not load and initialize hardware. Please check previous output for more "
                  "details. After you have corrected your URDF, try to publish robot description "
                  "again.");
      return;
    }
  } catch (const std::exception& error) {
    RCLCPP_ERROR(get_logger(), "Exception caught while loading and initializing components: %s",
                 error.what());
    return;
  }
  if (robot_description_notification_timer_) {
    robot_description_notification_timer_->cancel();
  }
}

void ControllerManager::set_components_to(const std::vector<std::string>& components, uint8_t state,
                                          const char* label, std::vector<std::string>& rest) {
  for (const std::string& name : components) {
    if (name.empty()) {
      continue;
    }
    if (!ros2_control::has_item(rest, name)) {
      RCLCPP_WARN(get_logger(),
                  "Hardware component '%s' is unknown, therefore not set in '%s' state.",
                  name.c_str(), label);
      continue;
    }
    RCLCPP_INFO(get_logger(), "Setting component '%s' to '%s' state.", name.c_str(), label);
    rclcpp_lifecycle::State target(state, label);
    if (resource_manager_->set_component_state(name, target) !=
        hardware_interface::return_type::OK) {
      if (declared<bool>(*this,
                         "hardware_components_initial_state.shutdown_on_initial_state_failure",
                         true, false)) {
        throw std::runtime_error("Failed to set the initial state of the component : " + name +
                                 " to " + label);
      }
      RCLCPP_ERROR(get_logger(), "Failed to set the initial state of the component : '%s' to '%s'",
                   name.c_str(), label);
    }
    std::ignore = ros2_control::remove_item(rest, name);
  }
}

void ControllerManager::set_initial_hardware_components_state() {
  std::vector<std::string> rest;
  for (const auto& entry : resource_manager_->get_components_status()) {
    rest.push_back(entry.first);
  }
  std::sort(rest.begin(), rest.end());
  const auto listed = [this](const char* name) {
    return declared<std::vector<std::string>>(
        *this, std::string("hardware_components_initial_state.") + name, {}, false);
  };
  namespace names = hardware_interface::lifecycle_state_names;
  set_components_to(listed("unconfigured"), State::PRIMARY_STATE_UNCONFIGURED, names::UNCONFIGURED,
                    rest);
  set_components_to(listed("inactive"), State::PRIMARY_STATE_INACTIVE, names::INACTIVE, rest);
  // All others are activated.
  const std::vector<std::string> others = rest;
  for (const std::string& name : others) {
    set_components_to({name}, State::PRIMARY_STATE_ACTIVE, names::ACTIVE, rest);
  }
}

void ControllerManager::init_services() {
  services_->start();
}

void ControllerManager::publish_activity() {
  services_->publish_activity();
}

bool ControllerManager::shutdown_controllers() {
  RCLCPP_INFO(get_logger(), "Shutting down all controllers in the controller manager.");
  std::vector<std::string> active;
  for (const ControllerSpec& spec : get_loaded_controllers()) {
    if (spec.c->get_lifecycle_id() == State::PRIMARY_STATE_ACTIVE) {
      active.push_back(spec.info.name);
    }
  }
  const std::lock_guard<std::recursive_mutex> lock(controllers_lock_);
  if (updates_) {
    shutdown_is_due_ = true;
    return true;
  }
  deactivate_controllers(active);
  bool done = true;
  for (const ControllerSpec& spec : controllers_) {
    if (spec.c->get_lifecycle_id() != State::PRIMARY_STATE_FINALIZED) {
      done = spec.c->get_node()->shutdown().id() == State::PRIMARY_STATE_FINALIZED && done;
    }
    executor_->remove_node(spec.c->get_node()->get_node_base_interface());
  }
  controllers_.clear();
  return done;
}

std::vector<ControllerSpec> ControllerManager::get_loaded_controllers() const {
  const std::lock_guard<std::recursive_mutex> lock(controllers_lock_);
  return controllers_;
}

ControllerSpec* ControllerManager::find_controller(const std::string& name) {
  for (ControllerSpec& spec : controllers_) {
    if (spec.info.name == name) {
      return &spec;
    }
  }
  return nullptr;
}

}  // namespace controller_manager
