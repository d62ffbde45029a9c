// See urdf_lumping.hpp.
#include "sdf/urdf_lumping.hpp"

#include "sdf/inertia.hpp"

namespace ros2wasm_sim {
namespace {

constexpr const char* kLumpPrefix = "_fixed_joint_lump__";

/// `L_collision_1`; what comes from another link C has its name as well, unless that begins with L.
std::string lumped_name(const std::string& link, const std::string& base, const char* ending,
                        std::size_t number) {
  const bool is_own = base.compare(0, link.size(), link) == 0;
  return (is_own ? "" : link + kLumpPrefix) + base + ending +
         (number == 0 ? "" : "_" + std::to_string(number));
}

template <typename T>
void add_shapes(const std::vector<T>& from, const std::string& owner, const std::string& link,
                const Pose& pose, const char* ending, std::vector<T>& to,
                std::unordered_map<std::string, std::string>* renamed) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    T shape = from[i];
    const std::string base = shape.name.empty() ? link : shape.name;
    shape.pose = pose * shape.pose;
    shape.name = lumped_name(owner, base, ending, to.size());
    const std::string expected = lumped_name(link, base, ending, i);
    if (renamed != nullptr && expected != shape.name) {
      renamed->emplace(expected, shape.name);
    }
    to.push_back(std::move(shape));
  }
}

void add_link(const UrdfLink& from, const Pose& pose, Link& to, Lumped& lumped) {
  const std::string& name = from.link.name;
  add_shapes(from.link.collisions, to.name, name, pose, "_collision", to.collisions,
             &lumped.renamed);
  add_shapes(from.link.visuals, to.name, name, pose, "_visual", to.visuals, nullptr);
  for (Sensor sensor : from.link.sensors) {
    sensor.pose = pose * sensor.pose;
    to.sensors.push_back(std::move(sensor));
  }
  for (Light light : from.link.lights) {
    light.pose = pose * light.pose;
    to.lights.push_back(std::move(light));
  }
  // A <gazebo> element of a lumped link counts for the whole link.
  to.gravity = to.gravity && from.link.gravity;
  to.kinematic = to.kinematic || from.link.kinematic;
  to.self_collide = to.self_collide || from.link.self_collide;
}

}  // namespace

bool is_lumped(const UrdfRobot& robot, const UrdfJoint& joint) {
  return joint.type == "fixed" && !joint.is_preserved && !joint.is_locked_axis &&
         robot.links[joint.parent].link.name != "world";
}

Lumped lump_fixed_joints(const UrdfRobot& robot) {
  Lumped result;
  result.owners.assign(robot.links.size(), kNone);
  std::vector<std::vector<Inertial>> bodies;
  for (const std::size_t i : robot.order) {
    const UrdfLink& link = robot.links[i];
    const bool is_gone = link.joint != kNone && is_lumped(robot, robot.joints[link.joint]);
    if (!is_gone) {
      LumpedLink kept;
      kept.link = i;
      kept.value.name = link.link.name;
      kept.value.pose = link.in_root;
      result.owners[i] = result.links.size();
      result.links.push_back(std::move(kept));
      bodies.emplace_back();
    } else {
      result.owners[i] = result.owners[robot.joints[link.joint].parent];
    }
    LumpedLink& owner = result.links[result.owners[i]];
    const Pose pose = is_gone ? inverse(owner.value.pose) * link.in_root : Pose{};
    add_link(link, pose, owner.value, result);
    if (link.inertial) {
      Inertial body = *link.inertial;
      body.pose = pose * body.pose;
      bodies[result.owners[i]].push_back(body);
    }
    if (is_gone) {
      result.frames.push_back({robot.joints[link.joint].name, owner.value.name, pose});
      if (robot.joints[link.joint].name != link.link.name) {
        result.frames.push_back({link.link.name, owner.value.name, pose});
      }
    }
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    result.links[i].has_inertial = !bodies[i].empty();
    if (!bodies[i].empty()) {
      result.links[i].value.inertial = combined(bodies[i]);
    }
  }
  return result;
}

}  // namespace ros2wasm_sim
