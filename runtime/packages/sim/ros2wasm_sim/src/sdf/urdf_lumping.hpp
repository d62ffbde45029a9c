// Lumping of fixed joints: the child of a fixed joint of a URDF becomes part of its parent link.
#pragma once

#include <unordered_map>

#include "sdf/urdf_robot.hpp"

namespace ros2wasm_sim {

/// A link that stays, with all that was lumped into it.
struct LumpedLink {
  std::size_t link = kNone;  ///< of the robot
  Link value;                ///< its pose is in the root
  bool has_inertial = false;
};

struct Lumped {
  std::vector<LumpedLink> links;    ///< in the order of the robot
  std::vector<std::size_t> owners;  ///< of each link of the robot: the index in `links`
  std::vector<Frame> frames;        ///< of the joints and links that are gone
  /// Names of collisions as a URDF's author expects them, where they have become others.
  std::unordered_map<std::string, std::string> renamed;
};

bool is_lumped(const UrdfRobot& robot, const UrdfJoint& joint);
Lumped lump_fixed_joints(const UrdfRobot& robot);

}  // namespace ros2wasm_sim
