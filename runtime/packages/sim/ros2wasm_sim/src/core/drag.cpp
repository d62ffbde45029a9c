// See drag.hpp.
#include "core/drag.hpp"

#include <algorithm>
#include <set>

namespace ros2wasm_sim {
namespace {

/// The natural frequency of the spring, in rad/s; it is critically damped.
constexpr double kStiffness = 12;
/// The strongest pull, in multiples of 1 m/s^2: a hand must not shoot a box through a wall.
constexpr double kMostAcceleration = 100;
constexpr std::int64_t kPatienceNs = 1'000'000'000;

}  // namespace

double rigid_mass(const Model& model, const std::string& link) {
  std::set<std::string> parts{link};
  for (bool grows = true; grows;) {
    grows = false;
    for (const Joint& joint : model.joints) {
      if (joint.type != JointType::kFixed) continue;
      if (parts.count(joint.child) != 0) grows |= parts.insert(joint.parent).second;
      if (parts.count(joint.parent) != 0) grows |= parts.insert(joint.child).second;
    }
  }
  double mass = 0;
  for (const Link& one : model.links)
    if (parts.count(one.name) != 0) mass += one.inertial.mass;
  return mass;
}

std::optional<Drag::Held> Drag::grip(const std::string& model, const std::string& link,
                                     const Vector3& point) {
  const Model* described = simulation_.model(model);
  if (described == nullptr || described->is_static) return std::nullopt;
  const LinkHandle handle = simulation_.physics().link(model, link);
  if (!handle.valid()) return std::nullopt;
  Held held;
  held.link = handle;
  held.point = point;
  held.mass = rigid_mass(*described, link);
  held.until_ns = now_ns_() + kPatienceNs;
  return held;
}

bool Drag::hold(const std::string& model, const std::string& link, const Vector3& point,
                const Vector3& target) {
  held_ = grip(model, link, point);
  if (held_) held_->target = target;
  return held_.has_value();
}

bool Drag::push(const std::string& model, const std::string& link, const Vector3& point,
                const Vector3& velocity) {
  const auto held = grip(model, link, point);
  if (!held) return false;
  Physics& physics = simulation_.physics();
  const Pose pose = physics.pose(held->link);
  const double share = held->mass / physics.step_size();
  physics.add_wrench(held->link, share * velocity, {},
                     pose.position + rotate(pose.orientation, held->point));
  return true;
}

void Drag::act() {
  if (!held_) return;
  if (now_ns_() > held_->until_ns) return release();
  Physics& physics = simulation_.physics();
  const Pose pose = physics.pose(held_->link);
  const Vector3 arm = rotate(pose.orientation, held_->point);
  const Motion motion = physics.velocity(held_->link);
  const Vector3 speed = motion.linear + cross(motion.angular, arm);
  // Stable in steps of any length: the damper must not turn a velocity round within one.
  const double frequency = std::min(kStiffness, 0.1 / physics.step_size());
  const Vector3 away = held_->target - (pose.position + arm);
  Vector3 wanted = frequency * frequency * away - 2 * frequency * speed;
  if (const double size = length(wanted); size > kMostAcceleration)
    wanted = (kMostAcceleration / size) * wanted;
  physics.add_wrench(held_->link, held_->mass * (wanted - simulation_.world().gravity), {},
                     pose.position + arm);
}

}  // namespace ros2wasm_sim
