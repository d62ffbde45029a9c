// The values that JointTrajectoryController reads from and writes to its interfaces.
#include <algorithm>
#include <cmath>
#include <limits>

#include "controller_interface/helpers.hpp"
#include "joint_trajectory_controller/joint_trajectory_controller.hpp"

namespace joint_trajectory_controller {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kKinds[] = {"position", "velocity", "acceleration", "effort"};

size_t kind_of(const std::string& name) {
  return static_cast<size_t>(std::find(std::begin(kKinds), std::end(kKinds), name) -
                             std::begin(kKinds));
}

template <class HandlesT>
void read_values(const HandlesT& handles, std::vector<double>& values) {
  values.resize(handles.size());
  for (size_t i = 0; i < handles.size(); ++i) {
    values[i] = handles[i].get().get_optional().value_or(values[i]);
  }
}

}  // namespace

template <class InterfaceT>
bool JointTrajectoryController::order_interfaces(std::vector<InterfaceT>& all,
                                                 const std::vector<std::string>& kinds,
                                                 const std::vector<std::string>& joints,
                                                 const char* what, Handles<InterfaceT>& ordered) {
  for (auto& handles : ordered) handles.clear();
  for (const std::string& kind : kinds) {
    auto& handles = ordered[kind_of(kind)];
    if (controller_interface::get_ordered_interfaces(all, joints, kind, handles)) continue;
    RCLCPP_ERROR(get_node()->get_logger(), "Expected %zu '%s' %s interfaces, got %zu.",
                 joints.size(), kind.c_str(), what, handles.size());
    return false;
  }
  return true;
}

bool JointTrajectoryController::take_interfaces() {
  return order_interfaces(command_interfaces_, params_.command_interfaces, command_joints_,
                          "command", command_handles_) &&
         order_interfaces(state_interfaces_, params_.state_interfaces, params_.joints, "state",
                          state_handles_);
}

void JointTrajectoryController::read_state(PathPoint& state) const {
  read_values(state_handles_[0], state.positions);
  // Velocities that are not measured are left out, so that they do not count in a spline.
  if (states_.velocity) {
    read_values(state_handles_[1], state.velocities);
  } else {
    state.velocities.clear();
  }
  if (states_.velocity && states_.acceleration) {
    read_values(state_handles_[2], state.accelerations);
  } else {
    state.accelerations.clear();
  }
  if (commands_.effort) state.effort = commands_of(3);
}

bool JointTrajectoryController::are_commands_set(size_t kind) const {
  const auto& handles = command_handles_[kind];
  return std::all_of(handles.begin(), handles.end(), [](const auto& handle) {
    return !std::isnan(handle.get().get_optional().value_or(kNotANumber));
  });
}

std::vector<double> JointTrajectoryController::commands_of(size_t kind) const {
  std::vector<double> values(params_.joints.size(), kNotANumber);
  for (size_t i = 0; i < command_handles_[kind].size(); ++i) {
    values[command_places_[i]] =
        command_handles_[kind][i].get().get_optional().value_or(kNotANumber);
  }
  return values;
}

void JointTrajectoryController::read_commands_as_state(PathPoint& state) const {
  if (commands_.position && are_commands_set(0)) state.positions = commands_of(0);
  if (commands_.velocity && are_commands_set(1)) state.velocities = commands_of(1);
  if (commands_.acceleration && are_commands_set(2)) state.accelerations = commands_of(2);
  if (commands_.effort && are_commands_set(3)) state.effort = commands_of(3);
}

bool JointTrajectoryController::read_commands(PathPoint& commands) const {
  bool are_all_set = true;
  const auto read = [&](bool has_kind, size_t kind, std::vector<double>& values) {
    values.clear();
    if (!has_kind) return;
    if (are_commands_set(kind)) {
      values = commands_of(kind);
    } else {
      are_all_set = false;
    }
  };
  read(commands_.position, 0, commands.positions);
  read(commands_.velocity, 1, commands.velocities);
  read(commands_.acceleration, 2, commands.accelerations);
  read(commands_.effort, 3, commands.effort);
  return are_all_set;
}

void JointTrajectoryController::write(size_t kind, const std::vector<double>& values) {
  for (size_t i = 0; i < command_handles_[kind].size(); ++i) {
    const size_t place = command_places_[i];
    // Points of a trajectory without interpolation may leave derivatives out.
    const double value = place < values.size() ? values[place] : 0.0;
    if (!command_handles_[kind][i].get().set_value(value)) {
      RCLCPP_DEBUG(get_node()->get_logger(), "Unable to set the %s of joint %s", kKinds[kind],
                   params_.joints[place].c_str());
    }
  }
}

void JointTrajectoryController::write_commands(const rclcpp::Duration& period) {
  const auto value_of = [](const std::vector<double>& values, size_t joint) {
    return joint < values.size() ? values[joint] : 0.0;
  };
  std::vector<double> output;
  if (uses_pids_) {
    output.assign(params_.joints.size(), 0.0);
    for (size_t i = 0; i < command_joints_.size(); ++i) {
      const size_t joint = command_places_[i];
      // The velocity that is wanted, and the effort, count beside the error.
      output[joint] =
          value_of(next_.velocities, joint) * ff_velocity_scale_[i] +
          (commands_.effort ? value_of(next_.effort, joint) : 0.0) +
          pids_[i]->compute_command(error_.positions[joint], error_.velocities[joint], period);
    }
  }
  if (commands_.position) write(0, next_.positions);
  if (commands_.velocity) write(1, uses_pids_ ? output : next_.velocities);
  if (commands_.acceleration) write(2, next_.accelerations);
  if (commands_.effort) write(3, uses_pids_ ? output : wanted_.effort);
}

void JointTrajectoryController::stop_commands() {
  for (size_t kind = 1; kind < command_handles_.size(); ++kind) {
    for (auto& handle : command_handles_[kind]) {
      if (!handle.get().set_value(0.0)) {
        RCLCPP_WARN(get_node()->get_logger(), "Error while setting joint %s to value 0.0",
                    kKinds[kind]);
      }
    }
  }
  for (auto& handles : command_handles_) handles.clear();
  for (auto& handles : state_handles_) handles.clear();
}

void JointTrajectoryController::publish_state(const rclcpp::Time& time) {
  if (!state_publisher_) return;
  state_message_.header.stamp = time;
  state_message_.reference = to_message(wanted_);
  state_message_.reference.effort.clear();
  state_message_.feedback = to_message(state_);
  state_message_.feedback.effort.clear();
  state_message_.error = to_message(error_);
  PathPoint commands;
  if (read_commands(commands)) state_message_.output = to_message(commands);
  state_message_.speed_scaling_factor = scaling_factor_;
  state_publisher_->try_publish(state_message_);
}

}  // namespace joint_trajectory_controller
