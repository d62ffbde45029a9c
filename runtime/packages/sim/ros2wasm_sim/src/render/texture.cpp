// See texture.hpp.
#include "render/texture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace ros2wasm_sim {
namespace {

/// The mean of each two by two pixels.
Picture half_of(const Picture& whole) {
  Picture half;
  half.width = std::max(1, whole.width / 2);
  half.height = std::max(1, whole.height / 2);
  half.rgb.resize(std::size_t{3} * half.width * half.height);
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x)
      for (int c = 0; c < 3; ++c) {
        int sum = 0;
        for (int dy = 0; dy < 2; ++dy)
          for (int dx = 0; dx < 2; ++dx) {
            const int at_x = std::min(2 * x + dx, whole.width - 1);
            const int at_y = std::min(2 * y + dy, whole.height - 1);
            sum += whole.rgb[3 * (std::size_t{1} * at_y * whole.width + at_x) + c];
          }
        half.rgb[3 * (std::size_t{1} * y * half.width + x) + c] =
            static_cast<std::uint8_t>((sum + 2) / 4);
      }
  return half;
}

/// The mean of the four nearest pixels, each by how near it is.
Vector3 texel(const Picture& picture, double u, double v) {
  const double x = (u - std::floor(u)) * picture.width - 0.5;
  const double y = (v - std::floor(v)) * picture.height - 0.5;
  const double whole_x = std::floor(x), whole_y = std::floor(y);
  const auto wrapped = [](int value, int size) {
    return value < 0 ? value + size : value >= size ? value - size : value;
  };
  const int left = static_cast<int>(whole_x), top = static_cast<int>(whole_y);
  const std::size_t columns[2] = {std::size_t{3} * wrapped(left, picture.width),
                                  std::size_t{3} * wrapped(left + 1, picture.width)};
  const std::size_t stride = std::size_t{3} * picture.width;
  const std::uint8_t* rows[2] = {&picture.rgb[stride * wrapped(top, picture.height)],
                                 &picture.rgb[stride * wrapped(top + 1, picture.height)]};
  const double fx = x - whole_x, fy = y - whole_y;
  const double weights[4] = {(1 - fy) * (1 - fx) / 255, (1 - fy) * fx / 255, fy * (1 - fx) / 255,
                             fy * fx / 255};
  const auto mix = [&](int c) {
    return weights[0] * rows[0][columns[0] + c] + weights[1] * rows[0][columns[1] + c] +
           weights[2] * rows[1][columns[0] + c] + weights[3] * rows[1][columns[1] + c];
  };
  return {mix(0), mix(1), mix(2)};
}

}  // namespace

Texture::Texture(Picture picture) {
  levels_.push_back(std::move(picture));
  while (levels_.back().width > 1 || levels_.back().height > 1)
    levels_.push_back(half_of(levels_.back()));
}

Vector3 Texture::at(double u, double v, double texels) const {
  if (!std::isfinite(u + v + texels)) return {1, 1, 1};
  // The level whose pixels are about as wide as the camera's: the border between two is in the
  // middle of their logarithms.
  int exponent = 0;
  std::frexp(texels * std::numbers::sqrt2, &exponent);
  const int last = static_cast<int>(levels_.size()) - 1;
  return texel(levels_[static_cast<std::size_t>(std::clamp(exponent - 1, 0, last))], u, v);
}

}  // namespace ros2wasm_sim
