// The noise of a sensor that measures a vector: one for each of its axes.
#pragma once

#include "plugins/parameters.hpp"
#include "sensors/noise.hpp"

namespace ros2wasm_sim {

struct AxesNoise {
  Noise x, y, z;

  /// `axes` has the elements `x`, `y` and `z`, each with a <noise>.
  static AxesNoise read(const Parameters& axes, Random& random) {
    const auto of = [&](const char* axis) {
      const Parameters given = axes.inside(axis);
      return Noise::read(given.xml(), given.find("noise"), random);
    };
    AxesNoise noise;
    noise.x = of("x");
    noise.y = of("y");
    noise.z = of("z");
    return noise;
  }

  Vector3 apply(const Vector3& v, Random& random) const {
    Vector3 result;
    result.x = x.apply(v.x, random);
    result.y = y.apply(v.y, random);
    result.z = z.apply(v.z, random);
    return result;
  }
};

}  // namespace ros2wasm_sim
