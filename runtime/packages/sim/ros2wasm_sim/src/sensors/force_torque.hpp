// The force and the torque that a joint carries: `force_torque`.
#pragma once

#include <string>
#include <vector>

#include "physics/physics.hpp"
#include "sensors/axes_noise.hpp"

namespace ros2wasm_sim {

/// The same wrench about another point, given along the same axes.
inline Wrench about(const Vector3& point, const Wrench& wrench) {
  return {wrench.force, wrench.torque - cross(point, wrench.force)};
}

class ForceTorque {
 public:
  /// Along which axes; the torque is about the sensor's origin in any case.
  enum class Frame { kChild, kParent, kSensor };

  /// `sensor` is one of `joint`; its pose is in the joint. Defaults are those of SDF: the axes of
  /// the child, and how the child acts on the parent.
  ForceTorque(const Sensor& sensor, Physics& physics, const std::string& model, const Joint& joint,
              std::uint64_t seed);

  /// Values of its elements that do not exist, in whose place the defaults count.
  const std::vector<std::string>& warnings() const { return warnings_; }
  Wrench measure();

 private:
  /// The text of an element, which must be one of these; otherwise the first one.
  std::string one_of(const Parameters& given, const char* element,
                     const std::vector<std::string>& values);

  Physics& physics_;
  LinkHandle child_, parent_;  ///< a parent that is not valid is the world
  Pose pose_;                  ///< of the sensor in the child
  Frame frame_ = Frame::kChild;
  bool is_on_child_ = false;
  Random random_;
  AxesNoise force_noise_, torque_noise_;
  std::string name_;
  std::vector<std::string> warnings_;
};

}  // namespace ros2wasm_sim
