// The cycle of the hardware: modes, limits, read and write.
#include <cmath>
#include <utility>

#include "hardware_interface/component_parser.hpp"
#include "hardware_interface/helpers.hpp"
#include "hardware_interface/resource_manager.hpp"
#include "joint_limits/joint_limits_helpers.hpp"
#include "resource_storage.hpp"

namespace hardware_interface {

using lifecycle_msgs::msg::State;
using Lock = std::lock_guard<std::recursive_mutex>;

namespace {

std::string lines_of(const std::vector<std::string>& names) {
  std::string text = "[\n";
  for (const std::string& name : names) {
    text += "  " + name + "\n";
  }
  return text + "]\n";
}

std::string switch_text(const std::vector<std::string>& start,
                        const std::vector<std::string>& stop) {
  return "Start interfaces: \n" + lines_of(start) + "Stop interfaces: \n" + lines_of(stop);
}

std::vector<std::string> common(const std::vector<std::string>& of_component,
                                const std::vector<std::string>& asked) {
  std::vector<std::string> result;
  for (const std::string& name : asked) {
    if (ros2_control::has_item(of_component, name)) {
      result.push_back(name);
    }
  }
  return result;
}

/// True when a component with a rate of its own has its turn: now is nearer to its period than the
/// next cycle would be.
bool has_its_turn(double since_last, unsigned int rate, unsigned int manager_rate) {
  const double error_now = std::abs(since_last * rate - 1.0);
  const double error_if_skipped = std::abs((since_last + 1.0 / manager_rate) * rate - 1.0);
  return error_now <= error_if_skipped;
}

/// Nothing for an interface that is missing, busy, or of another type: that has no limits.
std::optional<double> number_in(const Handle* interface) {
  const bool is_number =
      interface != nullptr && interface->get_data_type() == HandleDataType::DOUBLE;
  return is_number ? interface->get_optional() : std::nullopt;
}

using Read = return_type (HardwareComponent::*)(const rclcpp::Time&, const rclcpp::Duration&);

struct Half {
  const char* name;
  Read call;
  const rclcpp::Time& (HardwareComponent::*last)() const;
};

return_type run(const Half& half, HardwareComponent& component, unsigned int rate,
                unsigned int manager_rate, const rclcpp::Time& now,
                const rclcpp::Duration& period) {
  if (rate == 0 || rate == manager_rate) {
    return (component.*half.call)(now, period);
  }
  const rclcpp::Time& last = (component.*half.last)();
  // The first turn, and the first after simulated time was set back.
  const bool is_first = last.get_clock_type() == RCL_CLOCK_UNINITIALIZED || now < last;
  const rclcpp::Duration since = is_first ? rclcpp::Duration::from_seconds(1.0 / rate) : now - last;
  return has_its_turn(since.seconds(), rate, manager_rate) ? (component.*half.call)(now, since)
                                                           : return_type::OK;
}

const Half kRead = {"reading", &HardwareComponent::read, &HardwareComponent::get_last_read_time};
const Half kWrite = {"writing", &HardwareComponent::write, &HardwareComponent::get_last_write_time};

}  // namespace

bool ResourceManager::prepare_command_mode_switch(const std::vector<std::string>& start_interfaces,
                                                  const std::vector<std::string>& stop_interfaces) {
  const Lock lock(resources_lock_);
  std::vector<std::string> not_existing;
  std::vector<std::string> not_available;
  for (const auto* names : {&start_interfaces, &stop_interfaces}) {
    for (const std::string& name : *names) {
      if (!storage_->ledger.command(name)) {
        not_existing.push_back(name);
      } else if (!storage_->ledger.available_command(name)) {
        not_available.push_back(name);
      }
    }
  }
  if (!not_existing.empty() || !not_available.empty()) {
    const bool exist = not_existing.empty();
    RCLCPP_ERROR(get_logger(), "Not acceptable command interfaces combination: \n%s%s%s",
                 switch_text(start_interfaces, stop_interfaces).c_str(),
                 exist ? "Not available: \n" : "Not existing: \n",
                 lines_of(exist ? not_available : not_existing).c_str());
    return false;
  }
  bool accepted = true;
  for (HardwareComponent* const component : storage_->components()) {
    const std::string& name = component->get_name();
    const auto& own = storage_->info(name).command_interfaces;
    const auto start = common(own, start_interfaces);
    const auto stop = common(own, stop_interfaces);
    if (start.empty() && stop.empty()) {
      continue;
    }
    const uint8_t state = component->get_lifecycle_id();
    if (!start.empty() && state == State::PRIMARY_STATE_INACTIVE &&
        !allow_controller_activation_with_inactive_hardware_) {
      RCLCPP_WARN(get_logger(),
                  "Component '%s' is in INACTIVE state, but has start interfaces to switch: \n%s",
                  name.c_str(), switch_text(start, stop).c_str());
      return false;
    }
    const auto prepare = [&] { return component->prepare_command_mode_switch(start, stop); };
    if (state != State::PRIMARY_STATE_INACTIVE && state != State::PRIMARY_STATE_ACTIVE) {
      RCLCPP_WARN(get_logger(),
                  "Component '%s' is not in INACTIVE or ACTIVE state, skipping the prepare switch",
                  name.c_str());
      accepted = false;
    } else if (storage_->guarded<return_type>("preparing command mode switch for", name, prepare,
                                              return_type::ERROR) != return_type::OK) {
      RCLCPP_ERROR(get_logger(),
                   "Component '%s' did not accept command interfaces combination: \n%s",
                   name.c_str(), switch_text(start, stop).c_str());
      accepted = false;
    }
  }
  return accepted;
}

bool ResourceManager::perform_command_mode_switch(const std::vector<std::string>& start_interfaces,
                                                  const std::vector<std::string>& stop_interfaces) {
  const Lock lock(resources_lock_);
  bool done = true;
  for (HardwareComponent* const component : storage_->components()) {
    const std::string& name = component->get_name();
    const auto& own = storage_->info(name).command_interfaces;
    const auto start = common(own, start_interfaces);
    const auto stop = common(own, stop_interfaces);
    const uint8_t state = component->get_lifecycle_id();
    if ((start.empty() && stop.empty()) ||
        (state != State::PRIMARY_STATE_INACTIVE && state != State::PRIMARY_STATE_ACTIVE)) {
      continue;
    }
    const auto perform = [&] { return component->perform_command_mode_switch(start, stop); };
    if (storage_->guarded<return_type>("performing command mode switch for", name, perform,
                                       return_type::ERROR) != return_type::OK) {
      RCLCPP_ERROR(get_logger(), "Component '%s' could not perform switch", name.c_str());
      done = false;
    }
  }
  return done;
}

void ResourceManager::import_joint_limiters(const std::string& urdf) {
  const Lock lock(resources_lock_);
  for (const HardwareInfo& info : parse_control_resources_from_urdf(urdf)) {
    for (const ComponentInfo& joint : info.joints) {
      const auto limits = info.limits.find(joint.name);
      if (limits == info.limits.end() || !joint.enable_limits) {
        continue;
      }
      storage_->hard_limits[joint.name] = limits->second;
      storage_->limited_joints[joint.name].set_joint_name(joint.name);
      const auto soft = info.soft_limits.find(joint.name);
      if (soft != info.soft_limits.end()) {
        storage_->soft_limits[joint.name] = soft->second;
      }
    }
  }
}
const std::unordered_map<std::string, joint_limits::JointLimits>&
ResourceManager::get_hard_joint_limits() const {
  return storage_->hard_limits;
}
const std::unordered_map<std::string, joint_limits::SoftJointLimits>&
ResourceManager::get_soft_joint_limits() const {
  return storage_->soft_limits;
}

bool ResourceManager::enforce_command_limits(const rclcpp::Duration& period) {
  const std::unique_lock<std::recursive_mutex> lock(resources_lock_, std::try_to_lock);
  if (!lock.owns_lock()) {
    return false;
  }
  using joint_limits::JointControlInterfacesData;
  static const std::vector<
      std::pair<const char*, std::optional<double> JointControlInterfacesData::*>>
      kFields = {{HW_IF_POSITION, &JointControlInterfacesData::position},
                 {HW_IF_VELOCITY, &JointControlInterfacesData::velocity},
                 {HW_IF_EFFORT, &JointControlInterfacesData::effort},
                 {HW_IF_ACCELERATION, &JointControlInterfacesData::acceleration},
                 {"jerk", &JointControlInterfacesData::jerk}};
  bool limited = false;
  for (auto& [joint, data] : storage_->limited_joints) {
    for (const auto& [name, field] : kFields) {
      const std::string full_name = joint + "/" + name;
      const auto state = storage_->ledger.available_state(full_name);
      const auto command = storage_->ledger.available_command(full_name);
      data.actual.*field = number_in(state.get());
      data.command.*field = number_in(command.get());
    }
    data.limited = data.command;
    if (!joint_limits::saturate(joint, storage_->hard_limits[joint], data.actual, data.limited,
                                data.prev_command, period.seconds())) {
      continue;
    }
    limited = true;
    for (const auto& [name, field] : kFields) {
      const auto command = storage_->ledger.available_command(joint + "/" + name);
      if (command && (data.limited.*field).has_value()) {
        std::ignore = command->set_value(*(data.limited.*field), true);
      }
    }
  }
  return limited;
}

HardwareReadWriteStatus ResourceManager::read(const rclcpp::Time& /*time*/,
                                              const rclcpp::Duration& period) {
  HardwareReadWriteStatus status;
  const std::unique_lock<std::recursive_mutex> lock(resources_lock_, std::try_to_lock);
  if (!lock.owns_lock()) {
    return status;
  }
  for (HardwareComponent* const component : storage_->components()) {
    const std::string name = component->get_name();
    const auto read_one = [&] {
      const return_type result = run(kRead, *component, storage_->info(name).rw_rate,
                                     params_.update_rate, get_clock()->now(), period);
      return storage_->with_group(component->get_group_name(), result);
    };
    const return_type result =
        storage_->guarded<return_type>(kRead.name, name, read_one, return_type::ERROR);
    if (result == return_type::DEACTIVATE) {
      RCLCPP_WARN(get_logger(),
                  "DEACTIVATE returned from read cycle is treated the same as ERROR.");
    }
    if (result != return_type::OK) {
      component->error();
      status.result = return_type::ERROR;
      status.failed_hardware_names.push_back(name);
      storage_->withdraw(name);
    }
  }
  return status;
}

HardwareReadWriteStatus ResourceManager::write(const rclcpp::Time& /*time*/,
                                               const rclcpp::Duration& period) {
  HardwareReadWriteStatus status;
  const std::unique_lock<std::recursive_mutex> lock(resources_lock_, std::try_to_lock);
  if (!lock.owns_lock()) {
    return status;
  }
  for (HardwareComponent* const component : storage_->components()) {
    const std::string name = component->get_name();
    if (storage_->info(name).type == "sensor") {
      continue;
    }
    const auto write_one = [&] {
      const return_type result = run(kWrite, *component, storage_->info(name).rw_rate,
                                     params_.update_rate, get_clock()->now(), period);
      return storage_->with_group(component->get_group_name(), result);
    };
    const return_type result =
        storage_->guarded<return_type>(kWrite.name, name, write_one, return_type::ERROR);
    if (result == return_type::ERROR) {
      component->error();
      status.result = result;
      status.failed_hardware_names.push_back(name);
      storage_->withdraw(name);
    } else if (result == return_type::DEACTIVATE) {
      storage_->lead_to(*component, State::PRIMARY_STATE_INACTIVE);
      status.result = result;
      if (return_failed_hardware_names_on_return_deactivate_write_cycle_) {
        status.failed_hardware_names.push_back(name);
      }
    }
  }
  return status;
}

}  // namespace hardware_interface
