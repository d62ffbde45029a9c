// The formulas of transmissions. This file needs no ROS.
#include <algorithm>

#include "transmission_interface/accessor.hpp"
#include "transmission_interface/differential_transmission.hpp"
#include "transmission_interface/four_bar_linkage_transmission.hpp"
#include "transmission_interface/simple_transmission.hpp"

namespace transmission_interface {
namespace {

using namespace hardware_interface;

const std::vector<std::string> kAll = {HW_IF_POSITION, HW_IF_VELOCITY, HW_IF_EFFORT,
                                       HW_IF_TORQUE,   HW_IF_FORCE,    HW_IF_ABSOLUTE_POSITION};

bool is_position(const std::string& interface) {
  return interface == HW_IF_POSITION || interface == HW_IF_ABSOLUTE_POSITION;
}
bool is_motion(const std::string& interface) {
  return is_position(interface) || interface == HW_IF_VELOCITY;
}

template <typename HandleT>
void refuse_empty(const std::vector<HandleT>& handles, const char* kind) {
  if (handles.empty()) {
    throw Exception(std::string("No ") + kind + " handles were passed in");
  }
}

/// The handle of one interface; one without a value when there is none.
template <typename HandleT>
HandleT handle_of(const std::vector<HandleT>& handles, const std::string& interface) {
  const auto found = std::find_if(handles.begin(), handles.end(), [&](const HandleT& one) {
    return one.get_interface_name() == interface;
  });
  return found == handles.end() ? HandleT(handles.front().get_prefix_name(), interface, nullptr)
                                : *found;
}

template <typename HandleT>
bool has_value(const std::vector<HandleT>& handles, const std::vector<std::string>& interfaces) {
  return std::any_of(interfaces.begin(), interfaces.end(), [&](const std::string& interface) {
    return static_cast<bool>(handle_of(handles, interface));
  });
}

template <typename HandleT>
void refuse_other_count(const std::vector<HandleT>& handles, const char* kind) {
  const auto names = get_names(handles);
  if (names.size() != 2) {
    throw Exception(std::string("There should be exactly two unique ") + kind +
                    " names but was given '" + to_string(names) + "'.");
  }
}

}  // namespace

SimpleTransmission::SimpleTransmission(const double joint_to_actuator_reduction,
                                       const double joint_offset)
    : reduction_(joint_to_actuator_reduction), jnt_offset_(joint_offset) {
  if (reduction_ == 0.0) {
    throw Exception("Transmission reduction ratio cannot be zero.");
  }
}

std::vector<std::string> SimpleTransmission::get_supported_joint_interfaces() const {
  return kAll;
}

void SimpleTransmission::configure(const std::vector<JointHandle>& joint_handles,
                                   const std::vector<ActuatorHandle>& actuator_handles) {
  refuse_empty(joint_handles, "joint");
  refuse_empty(actuator_handles, "actuator");
  if (get_names(joint_handles).size() != 1) {
    throw Exception("Joint names given to transmissions should be identical");
  }
  if (get_names(actuator_handles).size() != 1) {
    throw Exception("Actuator names given to transmissions should be identical");
  }
  if (!has_value(joint_handles, kAll)) {
    throw Exception("None of the provided joint handles are valid or from the required interfaces");
  }
  if (!has_value(actuator_handles, kAll)) {
    throw Exception(
        "None of the provided actuator handles are valid or from the required interfaces");
  }
  pairs_.clear();
  for (const std::string& interface : kAll) {
    Pair pair{interface, handle_of(joint_handles, interface),
              handle_of(actuator_handles, interface)};
    if (pair.joint && pair.actuator) {
      pairs_.push_back(pair);
    }
  }
}

void SimpleTransmission::actuator_to_joint() {
  for (Pair& pair : pairs_) {
    const double value = pair.actuator.get_value();
    const double offset = is_position(pair.interface) ? jnt_offset_ : 0.0;
    pair.joint.set_value(is_motion(pair.interface) ? value / reduction_ + offset
                                                   : value * reduction_);
  }
}

void SimpleTransmission::joint_to_actuator() {
  for (Pair& pair : pairs_) {
    if (pair.interface == HW_IF_ABSOLUTE_POSITION) {
      continue;
    }
    const double value = pair.joint.get_value();
    const double offset = is_position(pair.interface) ? jnt_offset_ : 0.0;
    pair.actuator.set_value(is_motion(pair.interface) ? (value - offset) * reduction_
                                                      : value / reduction_);
  }
}

namespace detail {

TwoJointTransmission::TwoJointTransmission(const std::vector<double>& actuator_reduction,
                                           const std::vector<double>& joint_reduction,
                                           const std::vector<double>& joint_offset)
    : actuator_reduction_(actuator_reduction),
      joint_reduction_(joint_reduction),
      joint_offset_(joint_offset) {
  if (actuator_reduction.size() != 2 || joint_reduction.size() != 2 || joint_offset.size() != 2) {
    throw Exception("Reduction and offset vectors must have size 2.");
  }
  for (const auto* reductions : {&actuator_reduction, &joint_reduction}) {
    if (std::count(reductions->begin(), reductions->end(), 0.0) > 0) {
      throw Exception("Transmission reduction ratios cannot be zero.");
    }
  }
}

void TwoJointTransmission::configure(const std::vector<JointHandle>& joint_handles,
                                     const std::vector<ActuatorHandle>& actuator_handles) {
  refuse_empty(joint_handles, "joint");
  refuse_empty(actuator_handles, "actuator");
  refuse_other_count(joint_handles, "joint");
  refuse_other_count(actuator_handles, "actuator");
  rows_.clear();
  bool has_joints = false;
  bool has_actuators = false;
  bool fits = false;
  for (const std::string& interface : get_supported_joint_interfaces()) {
    Row row{interface, get_ordered_handles(joint_handles, get_names(joint_handles), interface),
            get_ordered_handles(actuator_handles, get_names(actuator_handles), interface)};
    has_joints = has_joints || row.joints.size() == 2;
    has_actuators = has_actuators || row.actuators.size() == 2;
    fits = fits || row.joints.size() == row.actuators.size();
    rows_.push_back(row);
  }
  if (!has_joints) {
    throw Exception("Not enough valid or required joint handles were presented.");
  }
  if (!has_actuators) {
    throw Exception("Not enough valid or required actuator handles were presented. \n" +
                    get_handles_info());
  }
  if (!fits) {
    throw Exception("Pair-wise mismatch on interfaces. \n" + get_handles_info());
  }
}

void TwoJointTransmission::actuator_to_joint() {
  for (Row& row : rows_) {
    if (row.joints.size() != 2 || row.actuators.size() != 2) {
      continue;
    }
    const Two given = {row.actuators[0].get_value(), row.actuators[1].get_value()};
    const Two result = is_motion(row.interface) ? joint_motion(given) : joint_effort(given);
    for (std::size_t i = 0; i < 2; ++i) {
      row.joints[i].set_value(result[i] + (is_position(row.interface) ? joint_offset_[i] : 0.0));
    }
  }
}

void TwoJointTransmission::joint_to_actuator() {
  for (Row& row : rows_) {
    if (row.joints.size() != 2 || row.actuators.size() != 2 ||
        row.interface == HW_IF_ABSOLUTE_POSITION) {
      continue;
    }
    Two given = {row.joints[0].get_value(), row.joints[1].get_value()};
    for (std::size_t i = 0; i < 2 && is_position(row.interface); ++i) {
      given[i] -= joint_offset_[i];
    }
    const Two result = is_motion(row.interface) ? actuator_motion(given) : actuator_effort(given);
    for (std::size_t i = 0; i < 2; ++i) {
      row.actuators[i].set_value(result[i]);
    }
  }
}

std::string TwoJointTransmission::get_handles_info() const {
  std::string text = "Got the following handles:";
  for (const Row& row : rows_) {
    std::string name = row.interface;
    std::replace(name.begin(), name.end(), '_', ' ');
    text += "\nJoint " + name + ": " + to_string(get_names(row.joints)) + ", Actuator " + name +
            ": " + to_string(get_names(row.actuators));
  }
  return text;
}

}  // namespace detail

std::vector<std::string> DifferentialTransmission::get_supported_joint_interfaces() const {
  return kAll;
}
DifferentialTransmission::Two DifferentialTransmission::joint_motion(const Two& actuator) const {
  const auto& ar = actuator_reduction_;
  const auto& jr = joint_reduction_;
  return {(actuator[0] / ar[0] + actuator[1] / ar[1]) / (2.0 * jr[0]),
          (actuator[0] / ar[0] - actuator[1] / ar[1]) / (2.0 * jr[1])};
}
DifferentialTransmission::Two DifferentialTransmission::actuator_motion(const Two& joint) const {
  const auto& ar = actuator_reduction_;
  const auto& jr = joint_reduction_;
  return {(joint[0] * jr[0] + joint[1] * jr[1]) * ar[0],
          (joint[0] * jr[0] - joint[1] * jr[1]) * ar[1]};
}
DifferentialTransmission::Two DifferentialTransmission::joint_effort(const Two& actuator) const {
  const auto& ar = actuator_reduction_;
  const auto& jr = joint_reduction_;
  return {jr[0] * (actuator[0] * ar[0] + actuator[1] * ar[1]),
          jr[1] * (actuator[0] * ar[0] - actuator[1] * ar[1])};
}
DifferentialTransmission::Two DifferentialTransmission::actuator_effort(const Two& joint) const {
  const auto& ar = actuator_reduction_;
  const auto& jr = joint_reduction_;
  return {(joint[0] / jr[0] + joint[1] / jr[1]) / (2.0 * ar[0]),
          (joint[0] / jr[0] - joint[1] / jr[1]) / (2.0 * ar[1])};
}

FourBarLinkageTransmission::Two FourBarLinkageTransmission::joint_motion(
    const Two& actuator) const {
  const auto& ar = actuator_reduction_;
  const auto& jr = joint_reduction_;
  const double first = actuator[0] / (jr[0] * ar[0]);
  return {first, (actuator[1] / ar[1] - first) / jr[1]};
}
FourBarLinkageTransmission::Two FourBarLinkageTransmission::actuator_motion(
    const Two& joint) const {
  const auto& ar = actuator_reduction_;
  const auto& jr = joint_reduction_;
  return {joint[0] * jr[0] * ar[0], (joint[0] + joint[1] * jr[1]) * ar[1]};
}
FourBarLinkageTransmission::Two FourBarLinkageTransmission::joint_effort(
    const Two& actuator) const {
  const auto& ar = actuator_reduction_;
  const auto& jr = joint_reduction_;
  return {jr[0] * actuator[0] * ar[0] + actuator[1] * ar[1], jr[1] * actuator[1] * ar[1]};
}
FourBarLinkageTransmission::Two FourBarLinkageTransmission::actuator_effort(
    const Two& joint) const {
  const auto& ar = actuator_reduction_;
  const auto& jr = joint_reduction_;
  return {(joint[0] - joint[1] / jr[1]) / (jr[0] * ar[0]), joint[1] / (ar[1] * jr[1])};
}

}  // namespace transmission_interface
