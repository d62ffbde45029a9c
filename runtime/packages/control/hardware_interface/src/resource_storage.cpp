// Loads components and leads them through their lives.
#include "resource_storage.hpp"

#include <algorithm>
#include <typeinfo>
#include <utility>

#include "hardware_interface/helpers.hpp"
#include "pluginlib/class_loader.hpp"

namespace hardware_interface {

using lifecycle_msgs::msg::State;

struct ResourceStorage::Loaders {
  pluginlib::ClassLoader<ActuatorInterface> actuators{"hardware_interface",
                                                      "hardware_interface::ActuatorInterface"};
  pluginlib::ClassLoader<SensorInterface> sensors{"hardware_interface",
                                                  "hardware_interface::SensorInterface"};
  pluginlib::ClassLoader<SystemInterface> systems{"hardware_interface",
                                                  "hardware_interface::SystemInterface"};

  std::unique_ptr<HardwareComponentInterface> make(const HardwareInfo& info) {
    const std::string& plugin = info.hardware_plugin_name;
    HardwareComponentInterface* made = nullptr;
    if (info.type == "actuator") {
      made = actuators.createUnmanagedInstance(plugin);
    } else if (info.type == "sensor") {
      made = sensors.createUnmanagedInstance(plugin);
    } else {
      made = systems.createUnmanagedInstance(plugin);
    }
    return std::unique_ptr<HardwareComponentInterface>(made);
  }
};

namespace {

int turn_of(const std::string& type) {
  return type == "actuator" ? 0 : type == "sensor" ? 1 : 2;
}

}  // namespace

ResourceStorage::ResourceStorage(rclcpp::Logger logger, bool handle_exceptions)
    : logger_(std::move(logger)), handle_exceptions_(handle_exceptions) {}

void ResourceStorage::log_exception(const char* doing, const std::string& component,
                                    const std::exception& error) {
  RCLCPP_ERROR(logger_, "Exception of type : %s occurred while %s hardware '%s': %s",
               typeid(error).name(), doing, component.c_str(), error.what());
}

std::unique_ptr<HardwareComponentInterface> ResourceStorage::load(const HardwareInfo& info) {
  RCLCPP_INFO(logger_, "Loading hardware '%s' ", info.name.c_str());
  std::unique_ptr<HardwareComponentInterface> plugin;
  try {
    if (!loaders_) {
      loaders_ = std::make_shared<Loaders>();
    }
    plugin = loaders_->make(info);
    RCLCPP_INFO(logger_, "Loaded hardware '%s' from plugin '%s'", info.name.c_str(),
                info.hardware_plugin_name.c_str());
  } catch (const pluginlib::PluginlibException& error) {
    RCLCPP_ERROR(logger_, "Caught exception of type : %s while loading hardware: %s",
                 typeid(error).name(), error.what());
    if (!handle_exceptions_) {
      throw;
    }
  } catch (const std::exception& error) {
    log_exception("loading", info.name, error);
    if (!handle_exceptions_) {
      throw;
    }
  }
  return plugin;
}

bool ResourceStorage::add(std::unique_ptr<HardwareComponentInterface> plugin,
                          const HardwareComponentParams& params) {
  const HardwareInfo& info = params.hardware_info;
  components_.emplace_back(std::move(plugin));
  HardwareComponent& component = components_.back();
  RCLCPP_INFO(logger_, "Initialize hardware '%s' ", info.name.c_str());
  const bool ready = guarded<bool>(
      "initializing", info.name,
      [&] { return component.initialize(params).id() == State::PRIMARY_STATE_UNCONFIGURED; },
      false);
  if (!ready) {
    RCLCPP_ERROR(logger_, "Failed to initialize hardware '%s'", info.name.c_str());
    return false;
  }
  RCLCPP_INFO(logger_, "Successful initialization of hardware '%s'", info.name.c_str());

  HardwareComponentInfo& known = infos_[info.name];
  known.name = info.name;
  known.type = info.type;
  known.group = info.group;
  known.plugin_name = info.hardware_plugin_name;
  known.is_async = info.is_async;
  known.rw_rate = info.rw_rate;
  groups_[info.group] = return_type::OK;
  return guarded<bool>(
      "importing interfaces of", info.name,
      [&] {
        for (const auto& state : component.export_state_interfaces()) {
          ledger.add(state);
          known.state_interfaces.push_back(state->get_name());
        }
        for (const auto& command : component.export_command_interfaces()) {
          ledger.add(command);
          known.command_interfaces.push_back(command->get_name());
        }
        return true;
      },
      false);
}

void ResourceStorage::clear() {
  components_.clear();
  infos_.clear();
  groups_.clear();
  ledger = InterfaceLedger();
  users.clear();
  limited_joints.clear();
  hard_limits.clear();
  soft_limits.clear();
}

bool ResourceStorage::step(HardwareComponent& component, const char* name,
                           const rclcpp_lifecycle::State& (HardwareComponent::*action)(),
                           uint8_t wanted) {
  const std::string& component_name = component.get_name();
  const rclcpp::Logger logger = rclcpp::get_logger("resource_manager");
  RCLCPP_INFO(logger, "'%s' hardware '%s' ", name, component_name.c_str());
  const bool reached = guarded<bool>(
      name, component_name, [&] { return (component.*action)().id() == wanted; }, false);
  if (reached) {
    RCLCPP_INFO(logger, "Successful '%s' of hardware '%s'", name, component_name.c_str());
  } else {
    RCLCPP_ERROR(logger, "Failed to '%s' hardware '%s'", name, component_name.c_str());
  }
  return reached;
}

bool ResourceStorage::configure(HardwareComponent& component) {
  const bool done =
      step(component, "configure", &HardwareComponent::configure, State::PRIMARY_STATE_INACTIVE);
  if (done) {
    const HardwareComponentInfo& known = infos_[component.get_name()];
    ledger.set_states_available(known.state_interfaces, true);
    ledger.set_commands_available(known.command_interfaces, true);
  }
  groups_[component.get_group_name()] = return_type::OK;
  return done;
}

void ResourceStorage::withdraw(const std::string& component) {
  const HardwareComponentInfo& known = infos_[component];
  ledger.set_states_available(known.state_interfaces, false);
  ledger.set_commands_available(known.command_interfaces, false);
}

bool ResourceStorage::lead_to(HardwareComponent& component, uint8_t target) {
  const std::string name = component.get_name();
  bool done = true;
  while (done && component.get_lifecycle_id() != target) {
    const uint8_t now = component.get_lifecycle_id();
    if (now == State::PRIMARY_STATE_FINALIZED) {
      RCLCPP_WARN(logger_, "hardware '%s' is in finalized state and can be only destroyed.",
                  name.c_str());
      done = false;
    } else if (now == State::PRIMARY_STATE_ACTIVE) {
      done = step(component, "deactivate", &HardwareComponent::deactivate,
                  State::PRIMARY_STATE_INACTIVE);
    } else if (target == State::PRIMARY_STATE_FINALIZED) {
      done = step(component, "shutdown", &HardwareComponent::shutdown, target);
      if (done) {
        withdraw(name);
      }
    } else if (now == State::PRIMARY_STATE_UNCONFIGURED) {
      done = configure(component);
    } else if (target == State::PRIMARY_STATE_ACTIVE) {
      done = step(component, "activate", &HardwareComponent::activate, target);
    } else if (target == State::PRIMARY_STATE_UNCONFIGURED) {
      done = step(component, "cleanup", &HardwareComponent::cleanup, target);
      if (done) {
        withdraw(name);
      }
      groups_[component.get_group_name()] = return_type::OK;
    } else {
      done = false;
    }
  }
  if (on_state_switch) {
    on_state_switch();
  }
  return done;
}

std::vector<HardwareComponent*> ResourceStorage::components() {
  std::vector<HardwareComponent*> result;
  for (HardwareComponent& component : components_) {
    result.push_back(&component);
  }
  std::stable_sort(result.begin(), result.end(), [this](const auto* a, const auto* b) {
    return turn_of(infos_[a->get_name()].type) < turn_of(infos_[b->get_name()].type);
  });
  return result;
}

HardwareComponent* ResourceStorage::find(const std::string& name) {
  for (HardwareComponent& component : components_) {
    if (component.get_name() == name) {
      return &component;
    }
  }
  return nullptr;
}

std::size_t ResourceStorage::count(const std::string& type) const {
  return static_cast<std::size_t>(
      std::count_if(infos_.begin(), infos_.end(),
                    [&type](const auto& entry) { return entry.second.type == type; }));
}

std::unordered_map<std::string, HardwareComponentInfo>& ResourceStorage::refreshed_infos() {
  for (const HardwareComponent& component : components_) {
    infos_[component.get_name()].state = component.get_lifecycle_state();
  }
  return infos_;
}

return_type ResourceStorage::with_group(const std::string& group, return_type result) {
  if (group.empty()) {
    return result;
  }
  if (result != return_type::OK) {
    groups_[group] = result;
  }
  return groups_[group];
}

}  // namespace hardware_interface
