// Reports what is probably wrong with a model, in sentences for its author. Pure. Correct models
// get none.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "world/world.hpp"

namespace ros2wasm_sim {

/// A number as people write it: `0.00033`.
std::string shown(double number);

/// Moments of inertia that are not those of a body of this mass and size, by a factor of 1000; 100
/// for the default of 1 kg m^2. One sentence at most, on the worst link.
std::optional<std::string> inertia_remark(const Model& model);

/// The height of the highest endless plane that lies flat, if there is one.
std::optional<double> ground_height(const World& world);

/// A model with joints or plugins that begins more than 2 cm below the ground.
std::optional<std::string> height_remark(const Model& model, double ground);

/// `; the nearest joint is [x]`, or nothing.
std::string nearest_joint(const Model& model, const std::string& wrong);

/// The link that a joint moves; null when there is none.
const Link* wheel_of(const Model& model, const std::string& joint);

/// The wheels of a drive with two sides, as its plugin describes them.
struct DrivenWheels {
  std::vector<std::string> left, right;  ///< names of joints
  double separation = 0;                 ///< metres
  double radius = 0;                     ///< metres
  /// Gazebo Classic has `wheel_diameter` in place of `wheel_radius`.
  bool writes_diameter = false;
};

/// Wheels without a collision, axes that turn the wrong way, and sizes that differ from those of
/// the wheels by more than 10 %.
std::vector<std::string> wheel_remarks(const Model& model, const DrivenWheels& wheels);

}  // namespace ros2wasm_sim
