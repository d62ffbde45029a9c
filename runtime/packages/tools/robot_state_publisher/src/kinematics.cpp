// See kinematics.hpp.
#include "robot_state_publisher/kinematics.hpp"

#include <cmath>
#include <stdexcept>

namespace robot_state_publisher {

urdf::Pose Segment::pose(double position) const {
  urdf::Pose result = joint->parent_to_joint_origin_transform;
  urdf::Vector3 axis = joint->axis;
  const double length = std::sqrt(axis.x * axis.x + axis.y * axis.y + axis.z * axis.z);
  if (length == 0) {
    return result;
  }
  axis = urdf::Vector3(axis.x / length, axis.y / length, axis.z / length);
  if (joint->type == urdf::Joint::PRISMATIC) {
    result.position =
        result.position +
        result.rotation * urdf::Vector3(axis.x * position, axis.y * position, axis.z * position);
  } else if (joint->type == urdf::Joint::REVOLUTE || joint->type == urdf::Joint::CONTINUOUS) {
    const double s = std::sin(position / 2);
    result.rotation = result.rotation *
                      urdf::Rotation(axis.x * s, axis.y * s, axis.z * s, std::cos(position / 2));
  }
  return result;
}

Kinematics read_kinematics(const std::string& urdf_xml) {
  urdf::Model model;
  if (!model.initString(urdf_xml)) {
    throw std::runtime_error("Unable to initialize urdf::model from robot description");
  }
  Kinematics result;
  for (const auto& [name, joint] : model.joints_) {
    const Segment segment{joint->parent_link_name, joint->child_link_name, joint};
    switch (joint->type) {
      case urdf::Joint::REVOLUTE:
      case urdf::Joint::CONTINUOUS:
      case urdf::Joint::PRISMATIC:
        result.moving.emplace(name, segment);
        break;
      case urdf::Joint::FLOATING:
        break;
      default:
        result.fixed.emplace(name, segment);
    }
    if (joint->mimic != nullptr) {
      result.mimic.emplace(name, *joint->mimic);
    }
  }
  return result;
}

}  // namespace robot_state_publisher
