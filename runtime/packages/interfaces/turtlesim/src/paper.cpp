// See paper.hpp.
#include "paper.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace turtlesim {
namespace {

constexpr std::uint32_t kOpaque = 0xff000000U;

/// Teleports lead anywhere, also to infinity.
double within_reach(double value) {
  constexpr double kFar = 10.0 * Paper::kSize;
  return std::isfinite(value) ? std::clamp(value, -kFar, kFar) : 0.0;
}

PixelPoint within_reach(PixelPoint point) {
  return {within_reach(point.x), within_reach(point.y)};
}

}  // namespace

void Paper::clear() {
  std::fill(pixels_.begin(), pixels_.end(), 0U);
  new_strokes_.clear();
  strokes_ = 0;
  ++number_;
}

void Paper::dot(PixelPoint center, double radius, std::uint32_t argb) {
  const int top = std::max(0, static_cast<int>(std::ceil(center.y - radius)));
  const int bottom = std::min(kSize - 1, static_cast<int>(std::floor(center.y + radius)));
  const int left = std::max(0, static_cast<int>(std::ceil(center.x - radius)));
  const int right = std::min(kSize - 1, static_cast<int>(std::floor(center.x + radius)));
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) {
      if (std::hypot(x - center.x, y - center.y) <= radius) {
        pixels_[static_cast<std::size_t>(y) * kSize + static_cast<std::size_t>(x)] = argb;
      }
    }
  }
}

void Paper::draw(PixelPoint from, PixelPoint to, const Pen& pen) {
  from = within_reach(from);
  to = within_reach(to);
  const std::uint32_t argb = kOpaque | static_cast<std::uint32_t>(pen.color.r) << 16U |
                             static_cast<std::uint32_t>(pen.color.g) << 8U | pen.color.b;
  // Thinner than this a dot may lie between the pixels.
  const double radius = std::max(0.75, pen.width / 2.0);
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const int steps = std::max(1, static_cast<int>(std::ceil(length * 2)));
  for (int i = 0; i <= steps; ++i) {
    const double part = static_cast<double>(i) / steps;
    dot({from.x + (to.x - from.x) * part, from.y + (to.y - from.y) * part}, radius, argb);
  }
  new_strokes_.push_back({from, to, pen.color, pen.width});
  ++strokes_;
}

Rgb Paper::color_at(PixelPoint point) const {
  constexpr Rgb kUntouched{255, 255, 255};
  const double x = std::round(within_reach(point.x));
  const double y = std::round(within_reach(point.y));
  if (x < 0 || y < 0 || x >= kSize || y >= kSize) return kUntouched;
  const std::uint32_t argb =
      pixels_[static_cast<std::size_t>(y) * kSize + static_cast<std::size_t>(x)];
  if (argb == 0) return kUntouched;
  return {static_cast<std::uint8_t>(argb >> 16U), static_cast<std::uint8_t>(argb >> 8U),
          static_cast<std::uint8_t>(argb)};
}

std::vector<PixelRun> Paper::runs() const {
  std::vector<PixelRun> result;
  for (const std::uint32_t argb : pixels_) {
    if (result.empty() || result.back().argb != argb) result.push_back({0, argb});
    ++result.back().length;
  }
  return result;
}

std::vector<PenStroke> Paper::take_new_strokes() {
  return std::exchange(new_strokes_, {});
}

}  // namespace turtlesim
