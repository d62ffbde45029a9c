// See joint_data.hpp.
#include "joint_state_broadcaster/joint_data.hpp"

#include <algorithm>
#include <limits>

namespace joint_state_broadcaster {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

bool is_standard(const std::string& interface) {
  return interface == "position" || interface == "velocity" || interface == "effort";
}

std::string standard_name(const std::string& interface, const JointDataOptions& options) {
  const auto found = options.standard_names.find(interface);
  return found == options.standard_names.end() ? interface : found->second;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

JointData::JointData(const std::vector<JointInterface>& interfaces,
                     const JointDataOptions& options) {
  for (const JointInterface& one : interfaces) {
    double& value = values_[one.joint][standard_name(one.interface, options)];
    value = kNotANumber;
    slots_.push_back(&value);
  }
  choose_names(interfaces, options);
  add_extra_joints(options.extra_joints);
}

void JointData::choose_names(const std::vector<JointInterface>& interfaces,
                             const JointDataOptions& options) {
  // By the last interface of each, as upstream.
  for (auto one = interfaces.rbegin(); one != interfaces.rend(); ++one) {
    if (is_standard(standard_name(one->interface, options)) && !contains(names_, one->joint)) {
      names_.push_back(one->joint);
    }
  }
  std::reverse(names_.begin(), names_.end());
  if (!options.filters_by_model) return;
  std::vector<std::string> filtered;
  for (const std::string& joint : options.model_joints) {
    if (contains(names_, joint)) filtered.push_back(joint);
  }
  names_ = std::move(filtered);
}

void JointData::add_extra_joints(const std::vector<std::string>& extra_joints) {
  for (const std::string& joint : extra_joints) {
    if (values_.count(joint) > 0) continue;
    values_[joint] = {{"position", 0.0}, {"velocity", 0.0}, {"effort", 0.0}};
    names_.push_back(joint);
  }
}

double JointData::value(const std::string& joint, const std::string& interface) const {
  const auto of_joint = values_.find(joint);
  if (of_joint == values_.end()) return kNotANumber;
  const auto found = of_joint->second.find(interface);
  return found == of_joint->second.end() ? kNotANumber : found->second;
}

}  // namespace joint_state_broadcaster
