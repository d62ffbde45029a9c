// See path_geometry.hpp.
#include "nav2_smoother/path_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace nav2_smoother {
namespace {

constexpr double kSame = 1e-4;  // m, rad

double angle_between(double from, double to) {
  return std::remainder(to - from, 2 * M_PI);
}

bool are_same(const PathPoint& a, const PathPoint& b) {
  return std::abs(b.x - a.x) < kSame && std::abs(b.y - a.y) < kSame;
}

double heading(const PathPoint& from, const PathPoint& to) {
  return std::atan2(to.y - from.y, to.x - from.x);
}

bool reverses(const PathPoint& before, const PathPoint& here, const PathPoint& after) {
  return (here.x - before.x) * (after.x - here.x) + (here.y - before.y) * (after.y - here.y) < 0.0;
}

bool turns_on_the_spot(const PathPoint& here, const PathPoint& after) {
  return are_same(here, after) && std::abs(angle_between(here.yaw, after.yaw)) > kSame;
}

/// One round over all points but the ends; how far they moved. Negative: one is not free.
double move_points(PathPoints& moved, const PathPoints& original,
                   const RelaxationSettings& settings,
                   const std::function<bool(const PathPoint&)>& is_free) {
  double change = 0.0;
  const auto pulled = [&settings](double first, double at, double before, double after) {
    return at + settings.data_weight * (first - at) +
           settings.smooth_weight * (after + before - 2.0 * at);
  };
  for (size_t i = 1; i + 1 < moved.size(); ++i) {
    const PathPoint old = moved[i];
    moved[i].x = pulled(original[i].x, old.x, moved[i - 1].x, moved[i + 1].x);
    moved[i].y = pulled(original[i].y, old.y, moved[i - 1].y, moved[i + 1].y);
    change += std::abs(moved[i].x - old.x) + std::abs(moved[i].y - old.y);
    // Points may be too far away for their distances to be numbers.
    if (!std::isfinite(change) || !is_free(moved[i])) return -1.0;
  }
  return change;
}

}  // namespace

std::vector<PointRange> parts_of(const PathPoints& path) {
  std::vector<PointRange> parts;
  size_t start = 0;
  const auto end_at = [&](size_t index) {
    parts.push_back({start, index});
    start = index;
  };
  for (size_t i = 1; i + 1 < path.size(); ++i) {
    if (reverses(path[i - 1], path[i], path[i + 1])) end_at(i);
    if (turns_on_the_spot(path[i], path[i + 1])) end_at(i);
  }
  if (!path.empty()) end_at(path.size() - 1);
  return parts;
}

bool turn_along(PathPoints& path) {
  if (path.size() < 3) return false;
  const bool is_backward = std::abs(angle_between(path[1].yaw, heading(path[1], path[2]))) > M_PI_2;
  for (size_t i = 0; i + 1 < path.size(); ++i) {
    if (are_same(path[i], path[i + 1])) continue;
    path[i].yaw = heading(path[i], path[i + 1]) + (is_backward ? M_PI : 0.0);
  }
  return is_backward;
}

void filter_savitzky_golay(PathPoints& path) {
  constexpr std::array<double, 7> kWeights{-2.0, 3.0, 6.0, 7.0, 6.0, 3.0, -2.0};
  constexpr double kSum = 21.0;
  const PathPoints before = path;
  const auto last = static_cast<ptrdiff_t>(path.size()) - 1;
  for (ptrdiff_t i = 1; i < last; ++i) {
    double x = 0.0;
    double y = 0.0;
    for (ptrdiff_t k = 0; k < 7; ++k) {
      const PathPoint& point =
          before[static_cast<size_t>(std::clamp<ptrdiff_t>(i + k - 3, 0, last))];
      x += kWeights[static_cast<size_t>(k)] / kSum * point.x;
      y += kWeights[static_cast<size_t>(k)] / kSum * point.y;
    }
    path[static_cast<size_t>(i)].x = x;
    path[static_cast<size_t>(i)].y = y;
  }
}

Relaxation relax(PathPoints& path, const RelaxationSettings& settings,
                 const std::function<bool(const PathPoint&)>& is_free,
                 const std::function<bool()>& is_late) {
  const PathPoints original = path;
  PathPoints moved = path;
  for (int round = 1;; ++round) {
    if (round >= settings.most_rounds) return Relaxation::too_many_rounds;
    if (is_late()) return Relaxation::late;
    const double change = move_points(moved, original, settings, is_free);
    if (change < 0.0) return Relaxation::blocked;
    path = moved;
    if (!(change >= settings.tolerance)) return Relaxation::done;
  }
}

}  // namespace nav2_smoother
