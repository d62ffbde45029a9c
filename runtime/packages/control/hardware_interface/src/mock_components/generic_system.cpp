// Hardware without hardware.
#include "mock_components/generic_system.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "pluginlib/class_list_macros.hpp"

namespace mock_components {
namespace {

using hardware_interface::HandleDataType;
using Interfaces = std::array<double, 3>;  ///< position, velocity, acceleration

/// One step of the laws of motion, of the interface in control. `offset` is added to positions.
void move(Interfaces& state, const Interfaces& command, size_t mode, double offset, double period) {
  double& position = state[POSITION_INTERFACE_INDEX];
  double& velocity = state[VELOCITY_INTERFACE_INDEX];
  double& acceleration = state[ACCELERATION_INTERFACE_INDEX];
  const double old_velocity = std::isfinite(velocity) ? velocity : 0.0;
  if (mode == POSITION_INTERFACE_INDEX) {
    if (std::isfinite(command[POSITION_INTERFACE_INDEX])) {
      const double old_position = position;
      position = command[POSITION_INTERFACE_INDEX] + offset;
      velocity = (position - old_position) / period;
      acceleration = (velocity - old_velocity) / period;
    }
    return;
  }
  if (mode == VELOCITY_INTERFACE_INDEX && std::isfinite(command[VELOCITY_INTERFACE_INDEX])) {
    velocity = command[VELOCITY_INTERFACE_INDEX];
    acceleration = (velocity - old_velocity) / period;
  } else if (mode == ACCELERATION_INTERFACE_INDEX) {
    if (std::isfinite(command[ACCELERATION_INTERFACE_INDEX])) {
      acceleration = command[ACCELERATION_INTERFACE_INDEX];
    }
    velocity = old_velocity + (std::isfinite(acceleration) ? acceleration * period : 0.0);
  }
  position += std::isfinite(velocity) ? velocity * period : offset;
}

}  // namespace

CallbackReturn GenericSystem::on_init(
    const hardware_interface::HardwareComponentInterfaceParams& params) {
  if (SystemInterface::on_init(params) != CallbackReturn::SUCCESS) {
    return CallbackReturn::ERROR;
  }
  const auto& given = get_hardware_info().hardware_parameters;
  const auto text_of = [&given](const char* name, const char* otherwise) {
    const auto found = given.find(name);
    return found == given.end() ? std::string(otherwise) : found->second;
  };
  const auto is_set = [&text_of](const char* name) {
    return hardware_interface::parse_bool(text_of(name, "false"));
  };
  use_mock_sensor_command_interfaces_ = is_set("mock_sensor_commands");
  use_mock_gpio_command_interfaces_ = is_set("mock_gpio_commands");
  command_propagation_disabled_ = is_set("disable_commands");
  calculate_dynamics_ = is_set("calculate_dynamics");
  position_state_following_offset_ =
      hardware_interface::stod(text_of("position_state_following_offset", "0.0"));
  if (given.count("position_state_following_offset") > 0) {
    custom_interface_with_following_offset_ = text_of("custom_interface_with_following_offset", "");
  }
  if (custom_interface_with_following_offset_.empty()) {
    return CallbackReturn::SUCCESS;
  }
  const auto has_it = [this](const auto& interfaces) {
    return std::any_of(interfaces.begin(), interfaces.end(), [this](const auto& interface) {
      return interface.name == custom_interface_with_following_offset_;
    });
  };
  const auto& joints = get_hardware_info().joints;
  if (std::any_of(joints.begin(), joints.end(), [&](const auto& joint) {
        return has_it(joint.command_interfaces) || has_it(joint.state_interfaces);
      })) {
    RCLCPP_INFO(get_logger(), "Custom interface with following offset '%s' found.",
                custom_interface_with_following_offset_.c_str());
  } else {
    RCLCPP_WARN(get_logger(),
                "Custom interface with following offset '%s' does not exist. Offset will not be "
                "applied",
                custom_interface_with_following_offset_.c_str());
  }
  return CallbackReturn::SUCCESS;
}

std::vector<hardware_interface::InterfaceDescription>
GenericSystem::export_unlisted_command_interface_descriptions() {
  std::vector<hardware_interface::InterfaceDescription> result;
  // A command for each state of the mocked components that has none.
  const auto add = [&result](const std::vector<hardware_interface::ComponentInfo>& components) {
    for (const auto& component : components) {
      for (const auto& state : component.state_interfaces) {
        const auto& commands = component.command_interfaces;
        if (std::none_of(commands.begin(), commands.end(),
                         [&state](const auto& command) { return command.name == state.name; })) {
          result.emplace_back(component.name, state);
        }
      }
    }
  };
  if (use_mock_sensor_command_interfaces_) {
    add(get_hardware_info().sensors);
  }
  if (use_mock_gpio_command_interfaces_) {
    add(get_hardware_info().gpios);
  }
  return result;
}

CallbackReturn GenericSystem::on_configure(const rclcpp_lifecycle::State&) {
  for (const auto& state : joint_states_) {
    if (state->get_data_type() != HandleDataType::DOUBLE) {
      continue;
    }
    const std::string& name = state->get_name();
    if (std::isnan(get_state(name))) {
      set_state(name, 0.0);
    }
    if (state->get_interface_name() == hardware_interface::HW_IF_POSITION &&
        custom_interface_with_following_offset_.empty()) {
      set_state(name, get_state(name) + position_state_following_offset_);
    }
  }
  joint_control_mode_.resize(get_hardware_info().joints.size(), POSITION_INTERFACE_INDEX);
  return CallbackReturn::SUCCESS;
}

return_type GenericSystem::prepare_command_mode_switch(
    const std::vector<std::string>& start_interfaces, const std::vector<std::string>&) {
  if (!calculate_dynamics_) {
    return return_type::OK;
  }
  return_type result = return_type::OK;
  for (const auto& joint : get_hardware_info().joints) {
    size_t modes = 0;
    bool is_asked = false;
    for (const std::string& name : start_interfaces) {
      is_asked = is_asked || name.find(joint.name + "/") == 0;
      for (size_t i = 0; i < 3; ++i) {
        modes += name == joint.name + "/" + standard_interfaces_[i] ? 1 : 0;
      }
    }
    if (is_asked && modes == 0) {
      RCLCPP_ERROR(get_logger(), "Joint '%s' has to have '%s', '%s', or '%s' interface!",
                   joint.name.c_str(), hardware_interface::HW_IF_POSITION,
                   hardware_interface::HW_IF_VELOCITY, hardware_interface::HW_IF_ACCELERATION);
      result = return_type::ERROR;
    } else if (modes > 1) {
      RCLCPP_ERROR(get_logger(),
                   "Got multiple (%zu) starting interfaces for joint '%s' - this is not supported!",
                   modes, joint.name.c_str());
      result = return_type::ERROR;
    }
  }
  return result;
}

return_type GenericSystem::perform_command_mode_switch(
    const std::vector<std::string>& start_interfaces, const std::vector<std::string>&) {
  const auto& joints = get_hardware_info().joints;
  for (size_t j = 0; calculate_dynamics_ && j < joints.size(); ++j) {
    for (size_t i = 0; i < 3; ++i) {
      const std::string name = joints[j].name + "/" + standard_interfaces_[i];
      if (std::count(start_interfaces.begin(), start_interfaces.end(), name) > 0) {
        joint_control_mode_[j] = i;
      }
    }
  }
  return return_type::OK;
}

void GenericSystem::set_if_there(const std::string& name, double value) {
  if (std::isfinite(value) && has_state(name)) {
    set_state(name, value);
  }
}

void GenericSystem::move_joint(size_t index, double period) {
  constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
  const std::string& joint = get_hardware_info().joints[index].name;
  const double offset =
      custom_interface_with_following_offset_.empty() ? position_state_following_offset_ : 0.0;
  if (!calculate_dynamics_) {
    const std::string name = joint + "/" + hardware_interface::HW_IF_POSITION;
    if (has_command(name)) {
      set_if_there(name, get_command(name) + offset);
    }
    return;
  }
  Interfaces state = {kNotANumber, kNotANumber, kNotANumber};
  Interfaces command = state;
  for (size_t i = 0; i < state.size(); ++i) {
    const std::string name = joint + "/" + standard_interfaces_[i];
    state[i] = has_state(name) ? get_state(name) : kNotANumber;
    command[i] = has_command(name) ? get_command(name) : kNotANumber;
  }
  move(state, command, joint_control_mode_[index], offset, period);
  for (size_t i = 0; i < state.size(); ++i) {
    set_if_there(joint + "/" + standard_interfaces_[i], state[i]);
  }
}

return_type GenericSystem::mirror(const hardware_interface::Handle& handle) {
  const std::string& name = handle.get_name();
  if (!has_command(name) || !has_state(name)) {
    return return_type::OK;
  }
  if (handle.get_data_type() == HandleDataType::BOOL) {
    set_state(name, get_command<bool>(name));
  } else if (handle.get_data_type() == HandleDataType::DOUBLE) {
    const double command = get_command(name);
    if (std::isinf(command)) {
      return return_type::ERROR;
    }
    set_if_there(name, command);
  }
  return return_type::OK;
}

/// Interfaces of joints beside those that move_joint sets.
return_type GenericSystem::mirror_joints() {
  const auto moved_end = standard_interfaces_.begin() + (calculate_dynamics_ ? 3 : 1);
  for (const auto& state : joint_states_) {
    const std::string& name = state->get_interface_name();
    if (std::find(standard_interfaces_.begin(), moved_end, name) != moved_end) {
      continue;
    }
    if (mirror(*state) != return_type::OK) {
      return return_type::ERROR;
    }
    const std::string position =
        state->get_prefix_name() + "/" + hardware_interface::HW_IF_POSITION;
    if (name == custom_interface_with_following_offset_ && has_command(position)) {
      set_if_there(state->get_name(), get_command(position) + position_state_following_offset_);
    }
  }
  return return_type::OK;
}

void GenericSystem::follow_mimicked_joints() {
  const auto& joints = get_hardware_info().joints;
  for (const auto& mimic : get_hardware_info().mimic_joints) {
    for (size_t i = 0; i < 3; ++i) {
      const std::string from =
          joints[mimic.mimicked_joint_index].name + "/" + standard_interfaces_[i];
      const double offset = i == POSITION_INTERFACE_INDEX ? mimic.offset : 0.0;
      if (has_state(from)) {
        set_if_there(joints[mimic.joint_index].name + "/" + standard_interfaces_[i],
                     offset + mimic.multiplier * get_state(from));
      }
    }
  }
}

return_type GenericSystem::read(const rclcpp::Time&, const rclcpp::Duration& period) {
  if (command_propagation_disabled_) {
    RCLCPP_WARN_ONCE(get_logger(), "Command propagation is disabled - no values will be returned!");
    return return_type::OK;
  }
  for (size_t i = 0; i < get_hardware_info().joints.size(); ++i) {
    const std::string position =
        get_hardware_info().joints[i].name + "/" + hardware_interface::HW_IF_POSITION;
    if (has_command(position) && std::isinf(get_command(position))) {
      return return_type::ERROR;
    }
    move_joint(i, period.seconds());
  }
  if (mirror_joints() != return_type::OK) {
    return return_type::ERROR;
  }
  follow_mimicked_joints();
  for (const auto* states : {&sensor_states_, &gpio_states_}) {
    for (const auto& state : *states) {
      if (mirror(*state) != return_type::OK) {
        return return_type::ERROR;
      }
    }
  }
  return return_type::OK;
}

}  // namespace mock_components

PLUGINLIB_EXPORT_CLASS(mock_components::GenericSystem, hardware_interface::SystemInterface)
