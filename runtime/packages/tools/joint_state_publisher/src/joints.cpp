// See joints.hpp.
#include "joints.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "ros2wasm_xml/xml_document.hpp"
#include "urdf_model/utils.h"

namespace joint_state_publisher {
namespace {

using ros2wasm_xml::XmlDocument;
using ros2wasm_xml::XmlElement;

std::optional<double> number_of(const XmlElement* element, const std::string& key) {
  const std::string* text = element == nullptr ? nullptr : element->attribute(key);
  if (text == nullptr) {
    return std::nullopt;
  }
  return urdf::strToDouble(text->c_str());
}

}  // namespace

void Joints::configure(const std::string& description,
                       const std::function<void(const std::string&)>& warn) {
  const XmlDocument xml(description);
  if (xml.root().name != "robot") {
    throw std::runtime_error("the root is not a robot");
  }
  std::vector<std::string> names;
  std::map<std::string, FreeJoint> free;
  std::map<std::string, DependentJoint> dependent = options_.dependent;
  static const std::set<std::string> kUnmoved{"fixed", "floating", "planar"};
  for (const XmlElement* element : xml.children(xml.root(), "joint")) {
    const std::string* type = element->attribute("type");
    const std::string* name = element->attribute("name");
    if (name == nullptr || type == nullptr || kUnmoved.count(*type) != 0) {
      continue;
    }
    FreeJoint joint;
    joint.is_continuous = *type == "continuous";
    const XmlElement* limit = xml.child(*element, "limit");
    const auto lower = joint.is_continuous ? -M_PI : number_of(limit, "lower");
    const auto upper = joint.is_continuous ? M_PI : number_of(limit, "upper");
    if (!lower || !upper) {
      warn(*name + " is not fixed, nor continuous, but limits are not specified!");
      continue;
    }
    joint.min = *lower;
    joint.max = *upper;
    if (options_.use_smallest_limits) {
      const XmlElement* safety = xml.child(*element, "safety_controller");
      joint.min = std::max(joint.min, number_of(safety, "soft_lower_limit").value_or(joint.min));
      joint.max = std::min(joint.max, number_of(safety, "soft_upper_limit").value_or(joint.max));
    }
    names.push_back(*name);
    const XmlElement* mimic = xml.child(*element, "mimic");
    if (options_.use_mimic && mimic != nullptr && mimic->attribute("joint") != nullptr) {
      dependent[*name] = {*mimic->attribute("joint"), number_of(mimic, "multiplier").value_or(1),
                          number_of(mimic, "offset").value_or(0)};
    }
    if (dependent.count(*name) != 0) {
      continue;
    }
    double zero = joint.min > 0 || joint.max < 0 ? (joint.min + joint.max) / 2 : 0;
    if (const auto told = options_.zeros.find(*name); told != options_.zeros.end()) {
      zero = told->second;
    }
    if (options_.publish_positions) {
      joint.position = zero;
    }
    if (options_.publish_velocities) {
      joint.velocity = 0;
    }
    if (options_.publish_efforts) {
      joint.effort = 0;
    }
    free[*name] = joint;
  }
  names_ = std::move(names);
  free_ = std::move(free);
  dependent_ = std::move(dependent);
}

void Joints::take(const sensor_msgs::msg::JointState& state) {
  for (std::size_t i = 0; i < state.name.size(); ++i) {
    const auto found = free_.find(state.name[i]);
    if (found == free_.end()) {
      continue;
    }
    FreeJoint& joint = found->second;
    if (i < state.position.size()) {
      joint.position = state.position[i];
    }
    if (i < state.velocity.size()) {
      joint.velocity = state.velocity[i];
    }
    if (i < state.effort.size()) {
      joint.effort = state.effort[i];
    }
  }
}

void Joints::move(double delta) {
  for (auto& [name, joint] : free_) {
    if (!joint.position) {
      continue;
    }
    double& position = *joint.position;
    position += joint.goes_forward ? delta : -delta;
    if (joint.goes_forward && position > joint.max) {
      position = joint.is_continuous ? joint.min : joint.max;
      joint.goes_forward = joint.is_continuous;
    } else if (!joint.goes_forward && position < joint.min) {
      position = joint.min;
      joint.goes_forward = true;
    }
  }
}

Joints::Source Joints::source_of(const std::string& name) const {
  Source source;
  std::set<std::string> passed;
  std::string at = name;
  while (free_.count(at) == 0) {
    const auto dependent = dependent_.find(at);
    if (dependent == dependent_.end()) {
      throw std::runtime_error("joint " + name + " follows " + at + ", which is not there");
    }
    if (!passed.insert(at).second) {
      throw std::runtime_error("Found an infinite recursive mimic chain: " + name);
    }
    source.offset += source.factor * dependent->second.offset;
    source.factor *= dependent->second.factor;
    at = dependent->second.parent.value();
  }
  source.joint = &free_.at(at);
  return source;
}

sensor_msgs::msg::JointState Joints::state() const {
  sensor_msgs::msg::JointState result;
  result.name = names_;
  const auto any = [this](std::optional<double> FreeJoint::*member) {
    return std::any_of(free_.begin(), free_.end(),
                       [&](const auto& one) { return (one.second.*member).has_value(); });
  };
  if (any(&FreeJoint::position) || !dependent_.empty()) {
    result.position.resize(names_.size());
  }
  if (any(&FreeJoint::velocity)) {
    result.velocity.resize(names_.size());
  }
  if (any(&FreeJoint::effort)) {
    result.effort.resize(names_.size());
  }
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const Source source = source_of(names_[i]);
    if (source.joint->position) {
      result.position[i] = *source.joint->position * source.factor + source.offset;
    }
    if (source.joint->velocity) {
      result.velocity[i] = *source.joint->velocity * source.factor;
    }
    if (source.joint->effort) {
      result.effort[i] = *source.joint->effort;
    }
  }
  return result;
}

}  // namespace joint_state_publisher
