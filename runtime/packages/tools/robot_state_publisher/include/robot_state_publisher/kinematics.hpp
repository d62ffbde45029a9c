// The frames of a robot and how they move, read from its description.
#pragma once

#include <map>
#include <string>

#include "urdf/model.h"
#include "urdf_model/pose.h"

namespace robot_state_publisher {

/// From one link to the next.
struct Segment {
  std::string root;
  std::string tip;
  urdf::JointConstSharedPtr joint;

  /// The pose of the tip in the root, with the joint at a position (radians or metres).
  urdf::Pose pose(double position) const;
};

struct Kinematics {
  std::map<std::string, Segment> moving;  ///< by joint
  std::map<std::string, Segment> fixed;   ///< by joint
  std::map<std::string, urdf::JointMimic> mimic;
};

/// Throws std::runtime_error when the text is not a description. Floating joints are skipped: their
/// frames come from elsewhere.
Kinematics read_kinematics(const std::string& urdf_xml);

}  // namespace robot_state_publisher
