// A URDF as it is written: links, joints and the tree that they are.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "sdf/sdf_frames.hpp"
#include "sdf/xml_values.hpp"

namespace ros2wasm_sim {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

struct UrdfLink {
  Node where;
  /// Contents of the link alone, in its own frame. Names of shapes are those of the URDF, or empty.
  Link link;
  std::optional<Inertial> inertial;
  Pose in_root;                    ///< with all joints at zero
  std::size_t joint = kNone;       ///< to its parent
  std::vector<std::size_t> below;  ///< joints to its children, by name
};

struct UrdfJoint {
  Node where;
  std::string name;
  std::string type;
  std::size_t parent = kNone;
  std::size_t child = kNone;
  Pose origin;  ///< of the child in the parent
  JointAxis axis;
  std::vector<Sensor> sensors;
  bool is_preserved = false;    ///< a fixed joint that stays one
  bool is_locked_axis = false;  ///< a fixed joint that becomes a revolute one with limits of zero
};

struct UrdfRobot {
  std::string name;
  Pose pose;
  std::vector<UrdfLink> links;
  std::vector<UrdfJoint> joints;
  std::unordered_map<std::string, std::size_t> link_index;
  std::unordered_map<std::string, std::size_t> joint_index;
  std::size_t root = kNone;
  std::vector<std::size_t>
      order;  ///< links, each after its parent and before its parent's next child

  bool has_world() const { return links[root].link.name == "world"; }
};

/// Nothing, with errors, when the links are not a tree.
std::optional<UrdfRobot> read_robot(Context& context, const Node& robot);

}  // namespace ros2wasm_sim
