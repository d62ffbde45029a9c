// See kdl_parser.hpp.
#include "kdl_parser/kdl_parser.hpp"

#include <fstream>
#include <sstream>
#include <vector>

#include "rcutils/logging_macros.h"
#include "urdf/model.h"

namespace kdl_parser {
namespace {

constexpr const char* kLogger = "kdl_parser";

KDL::Vector to_vector(const urdf::Vector3& v) {
  return {v.x, v.y, v.z};
}

KDL::Frame to_frame(const urdf::Pose& pose) {
  const urdf::Rotation& r = pose.rotation;
  return {KDL::Rotation::Quaternion(r.x, r.y, r.z, r.w), to_vector(pose.position)};
}

/// In the frame of the parent link, as KDL wants it.
KDL::Joint to_joint(const urdf::Joint& joint) {
  const KDL::Frame place = to_frame(joint.parent_to_joint_origin_transform);
  const KDL::Vector axis = place.M * to_vector(joint.axis);
  switch (joint.type) {
    case urdf::Joint::REVOLUTE:
    case urdf::Joint::CONTINUOUS:
      return KDL::Joint(joint.name, place.p, axis, KDL::Joint::RotAxis);
    case urdf::Joint::PRISMATIC:
      return KDL::Joint(joint.name, place.p, axis, KDL::Joint::TransAxis);
    case urdf::Joint::FIXED:
      break;
    default:
      RCUTILS_LOG_WARN_NAMED(kLogger,
                             "Converting unknown joint type of joint '%s' into a fixed joint",
                             joint.name.c_str());
  }
  return KDL::Joint(joint.name, KDL::Joint::None);
}

/// A description gives the inertia about the centre of mass in axes of its own; KDL wants it there
/// in the axes of the link.
KDL::RigidBodyInertia to_inertia(const urdf::Link& link) {
  if (!link.inertial) return KDL::RigidBodyInertia(0);
  const urdf::Inertial& of = *link.inertial;
  const KDL::Frame origin = to_frame(of.origin);
  const KDL::RotationalInertia own(of.ixx, of.iyy, of.izz, of.ixy, of.ixz, of.iyz);
  const KDL::RigidBodyInertia turned = origin.M * KDL::RigidBodyInertia(0, KDL::Vector(), own);
  return KDL::RigidBodyInertia(of.mass, origin.p, turned.getRotationalInertia());
}

}  // namespace

bool treeFromUrdfModel(const urdf::ModelInterface& robot_model, KDL::Tree& tree) {
  const urdf::LinkConstSharedPtr root = robot_model.getRoot();
  if (!root) return false;
  tree = KDL::Tree(root->name);
  if (root->inertial) {
    RCUTILS_LOG_WARN_NAMED(kLogger,
                           "The root link %s has an inertia specified in the URDF, but KDL does "
                           "not support a root link with an inertia.  As a workaround, you can add "
                           "an extra dummy link to your URDF.",
                           root->name.c_str());
  }
  // Depth first, each link before its children, without recursion: a description may be deep.
  std::vector<urdf::LinkSharedPtr> waiting(root->child_links.rbegin(), root->child_links.rend());
  while (!waiting.empty()) {
    const urdf::LinkSharedPtr link = waiting.back();
    waiting.pop_back();
    const urdf::Joint& joint = *link->parent_joint;
    const KDL::Segment segment(link->name, to_joint(joint),
                               to_frame(joint.parent_to_joint_origin_transform), to_inertia(*link));
    if (!tree.addSegment(segment, joint.parent_link_name)) return false;
    waiting.insert(waiting.end(), link->child_links.rbegin(), link->child_links.rend());
  }
  return true;
}

bool treeFromString(const std::string& xml, KDL::Tree& tree) {
  urdf::Model model;
  if (!model.initString(xml)) {
    RCUTILS_LOG_ERROR_NAMED(kLogger, "Could not generate robot model.");
    return false;
  }
  return treeFromUrdfModel(model, tree);
}

bool treeFromFile(const std::string& file, KDL::Tree& tree) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return treeFromString(text.str(), tree);
}

}  // namespace kdl_parser
