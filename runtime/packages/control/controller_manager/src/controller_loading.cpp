// Controllers come and go: load, configure, clean up, unload.
#include <algorithm>
#include <stdexcept>
#include <typeinfo>
#include <utility>

#include "controller_manager/controller_manager.hpp"
#include "hardware_interface/helpers.hpp"
#include "interface_names.hpp"
#include "switch_plan.hpp"

namespace controller_manager {

using controller_interface::ControllerInterfaceBaseSharedPtr;
using lifecycle_msgs::msg::State;
using Lock = std::lock_guard<std::recursive_mutex>;

namespace {

constexpr char kPackage[] = "controller_interface";
constexpr char kPlainBase[] = "controller_interface::ControllerInterface";
constexpr char kChainableBase[] = "controller_interface::ChainableControllerInterface";

LifeState life_state(uint8_t id) {
  switch (id) {
    case State::PRIMARY_STATE_UNCONFIGURED:
      return LifeState::kUnconfigured;
    case State::PRIMARY_STATE_INACTIVE:
      return LifeState::kInactive;
    case State::PRIMARY_STATE_ACTIVE:
      return LifeState::kActive;
    default:
      return LifeState::kOther;
  }
}

}  // namespace

void ControllerManager::make_loaders() {
  using controller_interface::ChainableControllerInterface;
  using controller_interface::ControllerInterface;
  if (!loader_) {
    loader_ = std::make_shared<pluginlib::ClassLoader<ControllerInterface>>(kPackage, kPlainBase);
    chainable_loader_ = std::make_shared<pluginlib::ClassLoader<ChainableControllerInterface>>(
        kPackage, kChainableBase);
  }
}

ControllerInterfaceBaseSharedPtr ControllerManager::load_controller(
    const std::string& controller_name, const std::string& controller_type) {
  RCLCPP_INFO(get_logger(), "Loading controller '%s'", controller_name.c_str());
  ControllerSpec spec;
  spec.info.name = controller_name;
  spec.info.type = controller_type;
  try {
    make_loaders();
    if (loader_->isClassAvailable(controller_type)) {
      spec.c = loader_->createSharedInstance(controller_type);
    } else if (chainable_loader_->isClassAvailable(controller_type)) {
      spec.c = chainable_loader_->createSharedInstance(controller_type);
    } else {
      RCLCPP_ERROR(get_logger(), "Loader for controller '%s' (type '%s') not found.",
                   controller_name.c_str(), controller_type.c_str());
      RCLCPP_INFO(get_logger(), "Available classes:");
      for (const auto& known :
           {loader_->getDeclaredClasses(), chainable_loader_->getDeclaredClasses()}) {
        for (const std::string& name : known) {
          RCLCPP_INFO(get_logger(), "  %s", name.c_str());
        }
      }
      return nullptr;
    }
  } catch (const std::exception& error) {
    RCLCPP_ERROR(get_logger(),
                 "Caught exception of type : %s while loading the controller '%s' of plugin type "
                 "'%s':\n%s",
                 typeid(error).name(), controller_name.c_str(), controller_type.c_str(),
                 error.what());
    if (!handle_exceptions_) {
      throw;
    }
    return nullptr;
  }
  read_controller_parameters(controller_name, spec.info);
  return add_controller_impl(spec);
}

void ControllerManager::read_controller_parameters(const std::string& name,
                                                   hardware_interface::ControllerInfo& info) {
  const auto texts = [this, &name](const char* suffix) {
    rclcpp::Parameter parameter;
    std::vector<std::string> result;
    if (!get_parameter(name + suffix, parameter)) {
      return result;
    }
    if (parameter.get_type() == rclcpp::ParameterType::PARAMETER_STRING) {
      result.push_back(parameter.as_string());
    } else if (parameter.get_type() == rclcpp::ParameterType::PARAMETER_STRING_ARRAY) {
      result = parameter.as_string_array();
    } else if (parameter.get_type() != rclcpp::ParameterType::PARAMETER_NOT_SET) {
      RCLCPP_ERROR(get_logger(),
                   "The '%s' param needs to be a string or a string array for '%s', but it is of "
                   "type %s",
                   suffix + 1, name.c_str(), parameter.get_type_name().c_str());
    }
    return result;
  };
  info.parameters_files = texts(".params_file");
  info.fallback_controllers_names = texts(".fallback_controllers");
  if (ros2_control::has_item(info.fallback_controllers_names, name)) {
    RCLCPP_ERROR(get_logger(), "Controller '%s' cannot be a fallback controller for itself.",
                 name.c_str());
    info.fallback_controllers_names.clear();
  }
  info.node_options_args = texts(".node_options_args");
}

ControllerInterfaceBaseSharedPtr ControllerManager::load_controller(
    const std::string& controller_name) {
  const std::string type = get_parameter_or<std::string>(controller_name + ".type", "");
  if (type.empty()) {
    RCLCPP_ERROR(get_logger(), "The 'type' param was not defined for '%s'.",
                 controller_name.c_str());
    return nullptr;
  }
  RCLCPP_INFO(get_logger(), "Loading controller : '%s' of type '%s'", controller_name.c_str(),
              type.c_str());
  return load_controller(controller_name, type);
}

rclcpp::NodeOptions ControllerManager::node_options_of(const ControllerSpec& controller) const {
  rclcpp::NodeOptions options = controller.c->define_custom_node_options();
  std::vector<std::string> arguments = options.arguments();
  const auto has_flag = [&arguments](const char* flag) {
    return ros2_control::has_item(arguments, std::string(flag));
  };
  const std::vector<std::string> flags = {"--remap", "-r", "--param", "-p"};
  for (const std::string& argument : options_.arguments()) {
    const auto contains = [&argument](const char* word) {
      return argument.find(word) != std::string::npos;
    };
    if (!contains("__ns") && !contains("__node") && !contains("robot_description")) {
      arguments.push_back(argument);
    } else if (!arguments.empty() && ros2_control::has_item(flags, arguments.back())) {
      arguments.pop_back();
    }
  }
  const auto add = [&](const std::vector<std::string>& more) {
    if (!more.empty() && !has_flag("--ros-args") &&
        !ros2_control::has_item(more, std::string("--ros-args"))) {
      arguments.emplace_back("--ros-args");
    }
    arguments.insert(arguments.end(), more.begin(), more.end());
  };
  for (const std::string& file : controller.info.parameters_files) {
    add({"--params-file", file});
  }
  if (use_sim_time_) {
    add({"-p", "use_sim_time:=true"});
  }
  add(controller.info.node_options_args);
  std::string text;
  for (const std::string& argument : arguments) {
    text += argument + " ";
  }
  RCLCPP_INFO(get_logger(), "Controller '%s' node arguments: %s", controller.info.name.c_str(),
              text.c_str());
  options.arguments(arguments);
  options.use_global_arguments(false);
  return options;
}

ControllerInterfaceBaseSharedPtr ControllerManager::add_controller_impl(
    const ControllerSpec& controller) {
  const std::string& name = controller.info.name;
  {
    const Lock lock(controllers_lock_);
    if (find_controller(name) != nullptr) {
      RCLCPP_ERROR(get_logger(),
                   "A controller named '%s' was already loaded inside the controller manager",
                   name.c_str());
      return nullptr;
    }
  }
  controller_interface::ControllerInterfaceParams params;
  params.controller_name = name;
  params.robot_description = robot_description_;
  params.update_rate = params.controller_manager_update_rate = update_rate_;
  params.node_namespace = get_namespace();
  if (resource_manager_) {
    params.hard_joint_limits = resource_manager_->get_hard_joint_limits();
    params.soft_joint_limits = resource_manager_->get_soft_joint_limits();
  }
  try {
    params.node_options = node_options_of(controller);
    if (controller.c->init(params) != ReturnType::OK) {
      RCLCPP_ERROR(get_logger(), "Could not initialize the controller named '%s'", name.c_str());
      return nullptr;
    }
  } catch (const std::exception& error) {
    RCLCPP_ERROR(get_logger(),
                 "Caught exception of type : %s while initializing controller '%s': %s",
                 typeid(error).name(), name.c_str(), error.what());
    if (!handle_exceptions_) {
      throw;
    }
    return nullptr;
  }
  executor_->add_node(controller.c->get_node()->get_node_base_interface());
  {
    const Lock lock(controllers_lock_);
    controllers_.push_back(controller);
    sort_controllers();
  }
  publish_activity();
  return controller.c;
}

std::vector<ControllerView> ControllerManager::controller_views() const {
  using Type = controller_interface::interface_configuration_type;
  const Lock lock(controllers_lock_);
  const auto available_commands = resource_manager_->available_command_interfaces();
  const auto available_states = resource_manager_->available_state_interfaces();
  std::vector<ControllerView> views;
  for (const ControllerSpec& spec : controllers_) {
    ControllerView view;
    view.name = spec.info.name;
    view.state = life_state(spec.c->get_lifecycle_id());
    view.is_chainable = spec.c->is_chainable();
    view.is_in_chained_mode = spec.c->is_in_chained_mode();
    view.fallbacks = spec.info.fallback_controllers_names;
    if (view.state == LifeState::kInactive || view.state == LifeState::kActive) {
      const auto commands = spec.c->command_interface_configuration();
      const auto states = spec.c->state_interface_configuration();
      view.commands = names_of(commands, available_commands);
      view.states = names_of(states, available_states);
      view.takes_all_commands = commands.type == Type::ALL;
      view.takes_all_states = states.type == Type::ALL;
    }
    view.references = resource_manager_->get_controller_reference_interface_names(view.name);
    view.exported_states =
        resource_manager_->get_controller_exported_state_interface_names(view.name);
    views.push_back(std::move(view));
  }
  return views;
}

void ControllerManager::sort_controllers() {
  const std::vector<ControllerView> views = controller_views();
  std::vector<ControllerSpec> sorted;
  for (const std::string& name : update_order(views)) {
    ControllerSpec spec = *find_controller(name);
    spec.controllers_chain_group = chain_of(name, views);
    sorted.push_back(std::move(spec));
  }
  controllers_ = std::move(sorted);
}

/// They are asked for again in each switch and list: what throws there must not be configured.
bool ControllerManager::interfaces_are_well_named(const ControllerSpec& controller) const {
  const auto are_unique = [&](const char* kind, const auto& configuration) {
    names_of(configuration, {});  // throws for a pattern that is not one
    if (ros2_control::is_unique(configuration.names)) {
      return true;
    }
    RCLCPP_ERROR(get_logger(),
                 "The %s interfaces of the controller '%s' are not unique. Please make sure that "
                 "the %s interfaces are unique.",
                 kind, controller.info.name.c_str(), kind);
    return false;
  };
  try {
    return are_unique("command", controller.c->command_interface_configuration()) &&
           are_unique("state", controller.c->state_interface_configuration());
  } catch (const std::exception& error) {
    RCLCPP_ERROR(get_logger(),
                 "Caught exception of type : %s while asking for the interfaces of controller "
                 "'%s': %s",
                 typeid(error).name(), controller.info.name.c_str(), error.what());
    if (!handle_exceptions_) {
      throw;
    }
    return false;
  }
}

ControllerManager::ReturnType ControllerManager::configure_controller(
    const std::string& controller_name) {
  RCLCPP_INFO(get_logger(), "Configuring controller: '%s'", controller_name.c_str());
  ControllerSpec spec;
  {
    const Lock lock(controllers_lock_);
    const ControllerSpec* const found = find_controller(controller_name);
    if (found == nullptr) {
      RCLCPP_ERROR(get_logger(),
                   "Could not configure controller with name '%s' because no controller with this "
                   "name exists",
                   controller_name.c_str());
      return ReturnType::ERROR;
    }
    spec = *found;
  }
  const auto& state = spec.c->get_lifecycle_state();
  if (state.id() != State::PRIMARY_STATE_INACTIVE &&
      state.id() != State::PRIMARY_STATE_UNCONFIGURED) {
    RCLCPP_ERROR(get_logger(), "Controller '%s' can not be configured from '%s' state.",
                 controller_name.c_str(), state.label().c_str());
    return ReturnType::ERROR;
  }
  if (state.id() == State::PRIMARY_STATE_INACTIVE) {
    RCLCPP_DEBUG(get_logger(), "Controller '%s' is cleaned-up before configuring",
                 controller_name.c_str());
    if (cleanup(spec) != ReturnType::OK) {
      return ReturnType::ERROR;
    }
  }
  try {
    const auto& after = spec.c->configure();
    if (after.id() != State::PRIMARY_STATE_INACTIVE) {
      RCLCPP_ERROR(get_logger(),
                   "After configuring, controller '%s' is in state '%s' , expected inactive.",
                   controller_name.c_str(), after.label().c_str());
      return ReturnType::ERROR;
    }
  } catch (const std::exception& error) {
    RCLCPP_ERROR(get_logger(),
                 "Caught exception of type : %s while configuring controller '%s': %s",
                 typeid(error).name(), controller_name.c_str(), error.what());
    if (!handle_exceptions_) {
      throw;
    }
    return ReturnType::ERROR;
  }
  const Lock lock(controllers_lock_);
  if (spec.c->is_chainable() && !export_interfaces(spec)) {
    return ReturnType::ERROR;
  }
  if (!interfaces_are_well_named(spec)) {
    spec.c->get_node()->cleanup();
    remove_exported_interfaces(spec);
    return ReturnType::ERROR;
  }
  sort_controllers();
  publish_activity();
  return ReturnType::OK;
}

bool ControllerManager::export_interfaces(const ControllerSpec& controller) {
  const std::string& name = controller.info.name;
  RCLCPP_DEBUG(get_logger(),
               "Controller '%s' is chainable. Interfaces are being exported to resource manager.",
               name.c_str());
  try {
    auto states = controller.c->export_state_interfaces();
    const auto references = controller.c->export_reference_interfaces();
    if (references.empty() && states.empty()) {
      RCLCPP_ERROR(get_logger(),
                   "Controller '%s' is chainable, but does not export any state or reference "
                   "interfaces. Did you override the on_export_state_interfaces_list() or "
                   "on_export_reference_interfaces_list() methods correctly?",
                   name.c_str());
      return false;
    }
    resource_manager_->import_controller_reference_interfaces(name, references);
    resource_manager_->import_controller_exported_state_interfaces(name, states);
  } catch (const std::exception& error) {
    RCLCPP_FATAL(get_logger(),
                 "Export of the state or reference interfaces failed with following error: %s",
                 error.what());
    return false;
  }
  return true;
}

void ControllerManager::remove_exported_interfaces(const ControllerSpec& controller) {
  if (controller.c->is_chainable()) {
    resource_manager_->remove_controller_reference_interfaces(controller.info.name);
    resource_manager_->remove_controller_exported_state_interfaces(controller.info.name);
  }
}

ControllerManager::ReturnType ControllerManager::cleanup(const ControllerSpec& controller) {
  remove_exported_interfaces(controller);
  try {
    const auto& after = controller.c->get_node()->cleanup();
    if (after.id() == State::PRIMARY_STATE_UNCONFIGURED) {
      return ReturnType::OK;
    }
    RCLCPP_ERROR(get_logger(),
                 "Controller '%s' is not cleaned-up properly, it is still in state '%s'",
                 controller.info.name.c_str(), after.label().c_str());
  } catch (const std::exception& error) {
    RCLCPP_ERROR(get_logger(), "Caught exception while cleaning-up the controller '%s': %s",
                 controller.info.name.c_str(), error.what());
    if (!handle_exceptions_) {
      throw;
    }
  }
  return ReturnType::ERROR;
}

ControllerManager::ReturnType ControllerManager::cleanup_controller(
    const std::string& controller_name) {
  RCLCPP_INFO(get_logger(), "Cleanup controller '%s'", controller_name.c_str());
  const Lock lock(controllers_lock_);
  const ControllerSpec* const found = find_controller(controller_name);
  if (found == nullptr) {
    RCLCPP_ERROR(get_logger(),
                 "Could not cleanup controller with name '%s' because no controller with this name "
                 "exists",
                 controller_name.c_str());
    return ReturnType::ERROR;
  }
  const auto& state = found->c->get_lifecycle_state();
  if (state.id() == State::PRIMARY_STATE_UNCONFIGURED) {
    return ReturnType::OK;
  }
  if (state.id() != State::PRIMARY_STATE_INACTIVE) {
    RCLCPP_ERROR(get_logger(), "Controller '%s' can not be cleaned-up from '%s' state.",
                 controller_name.c_str(), state.label().c_str());
    return ReturnType::ERROR;
  }
  const ReturnType result = cleanup(*found);
  publish_activity();
  return result;
}

ControllerManager::ReturnType ControllerManager::unload_controller(
    const std::string& controller_name) {
  RCLCPP_INFO(get_logger(), "Unloading controller: '%s'", controller_name.c_str());
  ControllerSpec removed;
  {
    const Lock lock(controllers_lock_);
    const ControllerSpec* const found = find_controller(controller_name);
    if (found == nullptr) {
      RCLCPP_ERROR(
          get_logger(),
          "Could not unload controller with name '%s' because no controller with this name "
          "exists",
          controller_name.c_str());
      return ReturnType::ERROR;
    }
    if (found->c->get_lifecycle_id() == State::PRIMARY_STATE_ACTIVE) {
      RCLCPP_ERROR(get_logger(),
                   "Could not unload controller with name '%s' because it is still active",
                   controller_name.c_str());
      return ReturnType::ERROR;
    }
    removed = *found;
    controllers_.erase(controllers_.begin() + (found - controllers_.data()));
  }
  if (removed.c->get_lifecycle_id() == State::PRIMARY_STATE_INACTIVE) {
    cleanup(removed);
  }
  if (removed.c->get_lifecycle_id() != State::PRIMARY_STATE_FINALIZED) {
    removed.c->get_node()->shutdown();
  }
  executor_->remove_node(removed.c->get_node()->get_node_base_interface());
  publish_activity();
  return ReturnType::OK;
}

}  // namespace controller_manager
