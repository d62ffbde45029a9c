// Loading of the components of a robot, and their interfaces.
#include "hardware_interface/resource_manager.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "hardware_interface/component_parser.hpp"
#include "hardware_interface/helpers.hpp"
#include "resource_storage.hpp"

namespace hardware_interface {

using lifecycle_msgs::msg::State;
using Lock = std::lock_guard<std::recursive_mutex>;

namespace {

ResourceManagerParams params_of(rclcpp::Clock::SharedPtr clock, rclcpp::Logger logger,
                                const std::string& urdf = "", bool activate_all = false,
                                unsigned int update_rate = 100) {
  ResourceManagerParams params;
  params.clock = std::move(clock);
  params.logger = std::move(logger);
  params.robot_description = urdf;
  params.activate_all = activate_all;
  params.update_rate = update_rate;
  return params;
}

rclcpp::Clock::SharedPtr clock_of(
    const rclcpp::node_interfaces::NodeClockInterface::SharedPtr& clock_interface) {
  if (!clock_interface) {
    throw std::invalid_argument(
        "Clock interface is nullptr. ResourceManager needs a valid clock interface.");
  }
  return clock_interface->get_clock();
}

rclcpp::Logger logger_of(
    const rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr& logger_interface) {
  return logger_interface ? logger_interface->get_logger().get_child("resource_manager")
                          : rclcpp::get_logger("resource_manager");
}

/// The interfaces of a description that its component did not export.
std::string missing_interfaces(const std::vector<HardwareInfo>& all,
                               const InterfaceLedger& ledger) {
  std::string states;
  std::string commands;
  for (const HardwareInfo& info : all) {
    for (const auto* components : {&info.joints, &info.sensors, &info.gpios}) {
      for (const InterfaceDescription& state : parse_state_interface_descriptions(*components)) {
        states += ledger.state(state.get_name()) ? "" : " " + state.get_name() + "\t";
      }
      if (components == &info.sensors) {
        continue;
      }
      for (const InterfaceDescription& command :
           parse_command_interface_descriptions(*components)) {
        commands += ledger.command(command.get_name()) ? "" : " " + command.get_name() + "\t";
      }
    }
  }
  return states.empty() && commands.empty() ? ""
                                            : "missing state interfaces:\n" + states +
                                                  "\nmissing command interfaces:\n" + commands;
}

}  // namespace

ResourceManager::ResourceManager(
    rclcpp::node_interfaces::NodeClockInterface::SharedPtr clock_interface,
    rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr logger_interface)
    : ResourceManager(clock_of(clock_interface), logger_of(logger_interface)) {}
ResourceManager::ResourceManager(rclcpp::Clock::SharedPtr clock, rclcpp::Logger logger)
    : ResourceManager(params_of(std::move(clock), std::move(logger)), false) {}
ResourceManager::ResourceManager(
    const std::string& urdf, rclcpp::node_interfaces::NodeClockInterface::SharedPtr clock_interface,
    rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr logger_interface, bool activate_all,
    const unsigned int update_rate)
    : ResourceManager(urdf, clock_of(clock_interface), logger_of(logger_interface), activate_all,
                      update_rate) {}
ResourceManager::ResourceManager(const std::string& urdf, rclcpp::Clock::SharedPtr clock,
                                 rclcpp::Logger logger, bool activate_all,
                                 const unsigned int update_rate)
    : ResourceManager(
          params_of(std::move(clock), std::move(logger), urdf, activate_all, update_rate), true) {}

ResourceManager::ResourceManager(const ResourceManagerParams& params, bool load)
    : allow_controller_activation_with_inactive_hardware_(
          params.allow_controller_activation_with_inactive_hardware),
      return_failed_hardware_names_on_return_deactivate_write_cycle_(
          params.return_failed_hardware_names_on_return_deactivate_write_cycle_),
      params_(params),
      storage_(std::make_unique<ResourceStorage>(params.logger, params.handle_exceptions)) {
  if (!params_.clock) {
    throw std::invalid_argument("Clock is nullptr. ResourceManager needs a valid clock.");
  }
  if (load) {
    ResourceManager::load_and_initialize_components(params);
  }
  if (load && params.activate_all) {
    for (HardwareComponent* const component : storage_->components()) {
      storage_->lead_to(*component, State::PRIMARY_STATE_ACTIVE);
    }
  }
}

ResourceManager::~ResourceManager() = default;

bool ResourceManager::shutdown_components() {
  const Lock lock(resources_lock_);
  bool done = true;
  for (HardwareComponent* const component : storage_->components()) {
    done = storage_->lead_to(*component, State::PRIMARY_STATE_FINALIZED) && done;
  }
  return done;
}

HardwareComponentParams ResourceManager::component_params(const HardwareInfo& info) const {
  HardwareComponentParams params;
  params.hardware_info = info;
  params.clock = params_.clock;
  rclcpp::Logger logger = params_.logger;
  params.logger = logger.get_child("hardware_component." + info.type + "." + info.name);
  params.executor = params_.executor;
  params.node_namespace = params_.node_namespace;
  return params;
}

bool ResourceManager::load_and_initialize_components(const ResourceManagerParams& params) {
  params_ = params;
  return load_and_initialize_components(params.robot_description, params.update_rate);
}

bool ResourceManager::load_and_initialize_components(const std::string& urdf,
                                                     const unsigned int update_rate) {
  params_.robot_description = urdf;
  params_.update_rate = update_rate;
  components_are_loaded_and_initialized_ = false;
  std::vector<HardwareInfo> all = parse_control_resources_from_urdf(urdf);
  const Lock lock(resources_lock_);
  bool done = true;
  for (HardwareInfo& info : all) {
    info.rw_rate = info.rw_rate == 0 ? update_rate : std::min(info.rw_rate, update_rate);
    if (storage_->find(info.name) != nullptr) {
      RCLCPP_ERROR(get_logger(),
                   "Hardware name %s is duplicated. Please provide a unique 'name' in the URDF.",
                   info.name.c_str());
      done = false;
    } else if (info.type == "system" || info.type == "actuator" || info.type == "sensor") {
      auto plugin = storage_->load(info);
      done = plugin && storage_->add(std::move(plugin), component_params(info));
    }
    if (!done) {
      break;
    }
  }
  const std::string missing = done ? missing_interfaces(all, storage_->ledger) : "";
  if (!missing.empty()) {
    RCLCPP_ERROR(get_logger(),
                 "Discrepancy between robot description file (urdf) and actually exported HW "
                 "interfaces.\nDetails: Wrong state or command interface configuration.\n%s",
                 missing.c_str());
  }
  components_are_loaded_and_initialized_ = done && missing.empty();
  if (!components_are_loaded_and_initialized_) {
    remove_all_components();
  }
  return components_are_loaded_and_initialized_;
}

void ResourceManager::remove_all_components() {
  const Lock lock(resources_lock_);
  storage_->clear();
}

bool ResourceManager::import(std::unique_ptr<HardwareComponentInterface> component,
                             const HardwareComponentParams& params) {
  const Lock lock(resources_lock_);
  HardwareComponentParams complete = component_params(params.hardware_info);
  complete.executor = params.executor.expired() ? complete.executor : params.executor;
  return storage_->add(std::move(component), complete);
}
void ResourceManager::import_component(std::unique_ptr<ActuatorInterface> actuator,
                                       const HardwareComponentParams& params) {
  import(std::move(actuator), params);
}
void ResourceManager::import_component(std::unique_ptr<SensorInterface> sensor,
                                       const HardwareComponentParams& params) {
  import(std::move(sensor), params);
}
void ResourceManager::import_component(std::unique_ptr<SystemInterface> system,
                                       const HardwareComponentParams& params) {
  import(std::move(system), params);
}
void ResourceManager::import_component(std::unique_ptr<ActuatorInterface> actuator,
                                       const HardwareInfo& hardware_info) {
  import(std::move(actuator), component_params(hardware_info));
}
void ResourceManager::import_component(std::unique_ptr<SensorInterface> sensor,
                                       const HardwareInfo& hardware_info) {
  import(std::move(sensor), component_params(hardware_info));
}
void ResourceManager::import_component(std::unique_ptr<SystemInterface> system,
                                       const HardwareInfo& hardware_info) {
  import(std::move(system), component_params(hardware_info));
}

size_t ResourceManager::actuator_components_size() const {
  return storage_->count("actuator");
}
size_t ResourceManager::sensor_components_size() const {
  return storage_->count("sensor");
}
size_t ResourceManager::system_components_size() const {
  return storage_->count("system");
}

const std::unordered_map<std::string, HardwareComponentInfo>&
ResourceManager::get_components_status() {
  const Lock lock(resources_lock_);
  return storage_->refreshed_infos();
}

return_type ResourceManager::set_component_state(const std::string& component_name,
                                                 rclcpp_lifecycle::State& target_state) {
  const Lock lock(resources_lock_);
  HardwareComponent* const component = storage_->find(component_name);
  if (component == nullptr) {
    RCLCPP_INFO(get_logger(), "Hardware Component with name '%s' does not exists",
                component_name.c_str());
    return return_type::ERROR;
  }
  static const std::map<std::string, uint8_t> kStates = {
      {lifecycle_state_names::UNCONFIGURED, State::PRIMARY_STATE_UNCONFIGURED},
      {lifecycle_state_names::INACTIVE, State::PRIMARY_STATE_INACTIVE},
      {lifecycle_state_names::ACTIVE, State::PRIMARY_STATE_ACTIVE},
      {lifecycle_state_names::FINALIZED, State::PRIMARY_STATE_FINALIZED}};
  const auto by_label = kStates.find(target_state.label());
  if (target_state.id() == 0 && by_label != kStates.end()) {
    target_state = rclcpp_lifecycle::State(by_label->second, by_label->first);
  }
  return storage_->lead_to(*component, target_state.id()) ? return_type::OK : return_type::ERROR;
}

void ResourceManager::set_on_component_state_switch_callback(std::function<void()> callback) {
  storage_->on_state_switch = std::move(callback);
}

}  // namespace hardware_interface
