// A picture on a surface.
#pragma once

#include <vector>

#include "render/picture.hpp"
#include "world/geometry.hpp"

namespace ros2wasm_sim {

class Texture {
 public:
  explicit Texture(Picture picture);

  const Picture& whole() const { return levels_.front(); }
  /// Its colour, from 0 to 1, at a place; (0, 0) is the upper left corner, and it repeats. `texels`
  /// of the whole picture are as wide as a pixel of the camera.
  Vector3 at(double u, double v, double texels) const;

 private:
  std::vector<Picture> levels_;  ///< each half as wide and high as the one before, down to a pixel
};

}  // namespace ros2wasm_sim
