// Draws a scene as a pinhole camera sees it, without a graphics card: the same picture, bit for
// bit, in Node.js and in every browser.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "render/picture.hpp"
#include "render/scene.hpp"

namespace ros2wasm_sim {

/// The middle of a pixel (column, row) is at (column + 0.5, row + 0.5).
struct Lens {
  int width = 320;
  int height = 240;
  double fx = 0, fy = 0;         ///< focal lengths, in pixels
  double cx = 0, cy = 0;         ///< where the axis meets the picture
  double near = 0.1, far = 100;  ///< metres along the axis
};

class Camera {
 public:
  explicit Camera(const Lens& lens);
  ~Camera();
  Camera(const Camera&) = delete;
  Camera& operator=(const Camera&) = delete;

  const Lens& lens() const { return lens_; }

  /// `pose` is that of the camera in the world; it looks along its x axis, z is up.
  void draw(RenderScene& scene, const Pose& pose);
  /// Measures the depths only.
  void draw_depth(RenderScene& scene, const Pose& pose);

  const Picture& picture() const { return picture_; }
  /// Metres along the axis from the camera to what a pixel shows, or infinity.
  float depth(int column, int row) const;

 private:
  class Work;
  Lens lens_;
  Picture picture_;
  std::unique_ptr<Work> work_;
};

}  // namespace ros2wasm_sim
