// See sim_hardware.hpp.
#include "sim_hardware.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "hardware_interface/lexical_casts.hpp"
#include "hardware_interface/types/hardware_interface_type_values.hpp"

namespace ros2wasm_sim {
namespace {

using hardware_interface::CallbackReturn;
using hardware_interface::ComponentInfo;
using hardware_interface::return_type;

/// A motor without a limit: more than any joint of a robot needs, in N m or N.
constexpr double kStrong = 1e4;

double strength(const Physics& physics, JointHandle joint) {
  return std::min(physics.effort_limit(joint), kStrong);
}

/// The position that the description gives a joint at the start.
std::optional<double> initial_position(const ComponentInfo& info) {
  for (const auto& state : info.state_interfaces) {
    if (state.name != hardware_interface::HW_IF_POSITION || state.initial_value.empty()) continue;
    try {
      return hardware_interface::stod(state.initial_value);
    } catch (const std::invalid_argument&) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

struct PlacedSensor {
  const Sensor* sensor = nullptr;
  const Link* link = nullptr;
};

/// By its own name, as the simulator has it.
PlacedSensor find_sensor(const Model& model, const std::string& name) {
  for (const Link& link : model.links)
    for (const Sensor& sensor : link.sensors)
      if (sensor.name == name) return {&sensor, &link};
  for (const Joint& joint : model.joints)
    for (const Sensor& sensor : joint.sensors) {
      if (sensor.name != name) continue;
      const auto child = std::find_if(model.links.begin(), model.links.end(),
                                      [&](const Link& link) { return link.name == joint.child; });
      if (child != model.links.end()) return {&sensor, &*child};
    }
  return {};
}

/// `x` of `linear_acceleration.x`.
double axis_of(const Vector3& vector, const std::string& interface) {
  switch (interface.back()) {
    case 'x':
      return vector.x;
    case 'y':
      return vector.y;
    default:
      return vector.z;
  }
}

double axis_of(const Quaternion& quaternion, const std::string& interface) {
  return interface.back() == 'w'
             ? quaternion.w
             : axis_of(Vector3{quaternion.x, quaternion.y, quaternion.z}, interface);
}

bool begins(const std::string& text, const char* with) {
  return text.rfind(with, 0) == 0;
}

}  // namespace

CallbackReturn SimHardware::on_init(
    const hardware_interface::HardwareComponentInterfaceParams& params) {
  auto own = params;
  std::vector<ComponentInfo>& joints = own.hardware_info.joints;
  for (auto info = joints.begin(); info != joints.end();) {
    const JointHandle joint = simulation_.physics().joint(settings_.model, info->name);
    if (joint.valid()) {
      add_joint(*info, joint);
      ++info;
      continue;
    }
    RCLCPP_WARN(get_logger(),
                "Skipping joint in the URDF named '%s' which is not in the gazebo model.",
                info->name.c_str());
    info = joints.erase(info);
  }
  return SystemInterface::on_init(own);
}

void SimHardware::add_joint(const ComponentInfo& info, JointHandle joint) {
  RCLCPP_INFO(get_logger(), "Loading joint: %s", info.name.c_str());
  DrivenJoint driven;
  driven.name = info.name;
  driven.joint = joint;
  driven.has_commands = !info.command_interfaces.empty();
  const auto list = [&](const char* title, const auto& interfaces) {
    RCLCPP_INFO(get_logger(), "\t%s:", title);
    for (const auto& one : interfaces) RCLCPP_INFO(get_logger(), "\t\t %s", one.name.c_str());
  };
  list("State", info.state_interfaces);
  list("Command", info.command_interfaces);
  if (const auto initial = initial_position(info)) {
    RCLCPP_INFO(get_logger(), "\t\t\t found initial value: %f", *initial);
    driven.initial = *initial;
    driven.has_initial = true;
  }
  driven_.push_back(std::move(driven));
}

CallbackReturn SimHardware::on_configure(const rclcpp_lifecycle::State&) {
  for (DrivenJoint& one : driven_) {
    find_interfaces(one);
    if (one.has_initial) simulation_.physics().set_position(one.joint, one.initial);
  }
  readings_.clear();
  for (const ComponentInfo& sensor : info_.sensors) find_readings(sensor);
  RCLCPP_INFO(get_logger(), "System Successfully configured!");
  return CallbackReturn::SUCCESS;
}

void SimHardware::find_interfaces(DrivenJoint& joint) {
  const auto state = [&](const char* kind) {
    const std::string name = joint.name + "/" + kind;
    return has_state(name) ? get_state_interface_handle(name) : nullptr;
  };
  const auto command = [&](const char* kind) {
    const std::string name = joint.name + "/" + kind;
    return has_command(name) ? get_command_interface_handle(name) : nullptr;
  };
  joint.position = state(hardware_interface::HW_IF_POSITION);
  joint.velocity = state(hardware_interface::HW_IF_VELOCITY);
  joint.effort = state(hardware_interface::HW_IF_EFFORT);
  joint.position_command = command(hardware_interface::HW_IF_POSITION);
  joint.velocity_command = command(hardware_interface::HW_IF_VELOCITY);
  joint.effort_command = command(hardware_interface::HW_IF_EFFORT);
}

void SimHardware::find_readings(const ComponentInfo& sensor) {
  RCLCPP_INFO(get_logger(), "Loading sensor: %s", sensor.name.c_str());
  for (const auto& interface : sensor.state_interfaces) {
    auto value = reading_of(sensor.name, interface.name);
    if (value) {
      readings_.push_back(
          {get_state_interface_handle(sensor.name + "/" + interface.name), std::move(value)});
    } else {
      RCLCPP_WARN(get_logger(), "the model [%s] has no sensor [%s] that measures [%s]",
                  settings_.model.c_str(), sensor.name.c_str(), interface.name.c_str());
    }
  }
}

std::function<double()> SimHardware::reading_of(const std::string& sensor,
                                                const std::string& interface) {
  const Model* model = simulation_.model(settings_.model);
  const PlacedSensor found = model == nullptr ? PlacedSensor() : find_sensor(*model, sensor);
  if (found.sensor == nullptr || interface.empty()) return {};
  Physics& physics = simulation_.physics();
  const LinkHandle link = physics.link(settings_.model, found.link->name);
  const Pose in_link = found.sensor->pose;
  const auto turned = [&physics, link, in_link](const Vector3& in_world) {
    return rotate(inverse(physics.pose(link).orientation * in_link.orientation), in_world);
  };
  if (found.sensor->type == "imu") {
    if (begins(interface, "orientation."))
      return [&physics, link, in_link, interface] {
        return axis_of(physics.pose(link).orientation * in_link.orientation, interface);
      };
    if (begins(interface, "angular_velocity."))
      return [&physics, link, turned, interface] {
        return axis_of(turned(physics.velocity(link).angular), interface);
      };
    if (begins(interface, "linear_acceleration."))
      return [&physics, link, turned, interface] {
        return axis_of(turned(physics.proper_acceleration(link).linear), interface);
      };
  }
  if (found.sensor->type == "force_torque") {
    physics.watch_wrench(link);
    if (begins(interface, "force."))
      return [&physics, link, interface] { return axis_of(physics.wrench(link).force, interface); };
    if (begins(interface, "torque."))
      return
          [&physics, link, interface] { return axis_of(physics.wrench(link).torque, interface); };
  }
  return {};
}

return_type SimHardware::perform_command_mode_switch(const std::vector<std::string>& start,
                                                     const std::vector<std::string>& stop) {
  for (DrivenJoint& one : driven_) {
    const auto set = [&](const char* kind, Mode mode) {
      const std::string name = one.name + "/" + kind;
      const auto has = [&](const std::vector<std::string>& names) {
        return std::find(names.begin(), names.end(), name) != names.end();
      };
      if (has(stop) && one.mode == mode) {
        one.mode = Mode::kNone;
        simulation_.physics().release_motor(one.joint);
      }
      if (has(start)) one.mode = mode;
    };
    set(hardware_interface::HW_IF_POSITION, Mode::kPosition);
    set(hardware_interface::HW_IF_VELOCITY, Mode::kVelocity);
    set(hardware_interface::HW_IF_EFFORT, Mode::kEffort);
    if (one.mode == Mode::kEffort) simulation_.physics().release_motor(one.joint);
  }
  return return_type::OK;
}

return_type SimHardware::read(const rclcpp::Time&, const rclcpp::Duration&) {
  Physics& physics = simulation_.physics();
  for (const DrivenJoint& one : driven_) {
    if (one.position) set_state(one.position, physics.position(one.joint), true);
    if (one.velocity) set_state(one.velocity, physics.velocity(one.joint), true);
    if (one.effort) set_state(one.effort, physics.effort(one.joint), true);
  }
  for (const Reading& one : readings_) set_state(one.state, one.value(), true);
  return return_type::OK;
}

return_type SimHardware::write(const rclcpp::Time&, const rclcpp::Duration&) {
  for (const DrivenJoint& one : driven_) command(one);
  return return_type::OK;
}

void SimHardware::command(const DrivenJoint& joint) {
  Physics& physics = simulation_.physics();
  const auto commanded = [&](const hardware_interface::CommandInterface::SharedPtr& interface) {
    double value = std::nan("");
    if (interface) (void)get_command(interface, value, true);
    // An infinite command would end the physics: it is none, as NaN is.
    return std::isfinite(value) ? value : std::nan("");
  };
  const double limit = strength(physics, joint.joint);
  if (joint.mode == Mode::kPosition) {
    const double wanted = commanded(joint.position_command);
    if (std::isnan(wanted)) return;
    if (settings_.flavour == Flavour::kClassic) return physics.set_position(joint.joint, wanted);
    const double error = physics.position(joint.joint) - wanted;
    physics.set_motor(joint.joint, -settings_.position_gain * error * settings_.update_rate, limit);
  } else if (joint.mode == Mode::kVelocity) {
    const double wanted = commanded(joint.velocity_command);
    if (!std::isnan(wanted)) physics.set_motor(joint.joint, wanted, limit);
  } else if (joint.mode == Mode::kEffort) {
    const double wanted = commanded(joint.effort_command);
    if (!std::isnan(wanted)) physics.add_effort(joint.joint, wanted);
  } else if (joint.has_commands && settings_.hold_joints) {
    physics.set_motor(joint.joint, 0, limit);
  }
}

}  // namespace ros2wasm_sim
