// See path.hpp.
#include "joint_trajectory_controller/path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace joint_trajectory_controller {
namespace {

double seconds(int64_t ns) {
  return static_cast<double>(ns) * 1e-9;
}

}  // namespace

void Path::start(std::shared_ptr<PathRequest> request) {
  request_ = std::move(request);
  start_ns_ = request_->start_ns;
  is_sampled_ = false;
  last_segment_ = 0;
}

void Path::set_point_before(int64_t time_ns, const PathPoint& state,
                            const std::vector<bool>& wraps) {
  before_ns_ = time_ns;
  before_ = state;
  // Derivatives that the first point has are 0 here: the first segment is a spline of the same
  // degree as the others.
  const PathPoint& first = request_->points.front();
  if (before_.velocities.empty()) before_.velocities.assign(first.velocities.size(), 0.0);
  if (before_.accelerations.empty()) before_.accelerations.assign(first.accelerations.size(), 0.0);
  wrap_around(before_.positions, first.positions, wraps);
}

void Path::deduce_points() {
  std::vector<PathPoint>& points = request_->points;
  const size_t joints = before_.positions.size();
  deduce_from_derivatives(before_, points[0], joints, seconds(time_of(0) - before_ns_));
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    deduce_from_derivatives(points[i], points[i + 1], joints, seconds(time_of(i + 1) - time_of(i)));
  }
}

std::optional<Segment> Path::sample(int64_t time_ns, Interpolation method, PathPoint& wanted,
                                    bool only_looks) {
  if (!request_ || request_->points.empty()) return std::nullopt;
  if (!is_sampled_ && start_ns_ == 0) start_ns_ = time_ns;
  if (!is_sampled_) deduce_points();
  is_sampled_ = true;
  if (time_ns < before_ns_) return std::nullopt;

  const std::vector<PathPoint>& points = request_->points;
  if (time_ns < time_of(0)) {
    if (method == Interpolation::kNone) {
      wanted = before_;
    } else {
      wanted = interpolate(before_, points[0], seconds(time_ns - before_ns_),
                           seconds(time_of(0) - before_ns_));
    }
    return Segment{};
  }
  for (size_t i = last_segment_; i + 1 < points.size(); ++i) {
    if (time_ns < time_of(i) || time_ns >= time_of(i + 1)) continue;
    if (method == Interpolation::kNone) {
      wanted = points[i + 1];
    } else {
      wanted = interpolate(points[i], points[i + 1], seconds(time_ns - time_of(i)),
                           seconds(time_of(i + 1) - time_of(i)));
    }
    wanted.from_start_ns = points[i + 1].from_start_ns;
    if (!only_looks) last_segment_ = i;
    return Segment{i, i + 1};
  }
  const size_t last = points.size() - 1;
  if (!only_looks) last_segment_ = last;
  wanted = points[last];
  const size_t joints = wanted.positions.size();
  if (wanted.velocities.empty()) wanted.velocities.assign(joints, 0.0);
  if (wanted.accelerations.empty()) wanted.accelerations.assign(joints, 0.0);
  if (wanted.effort.empty()) wanted.effort.assign(joints, 0.0);
  return Segment{last, points.size()};
}

PathRequest braking_path(const std::vector<std::string>& joints, const PathPoint& state,
                         const std::vector<double>& max_deceleration, double period_s) {
  double longest_s = 0.0;
  for (size_t i = 0; i < joints.size(); ++i) {
    longest_s = std::max(longest_s, std::abs(state.velocities[i]) / max_deceleration[i]);
  }
  PathRequest request;
  request.joints = joints;
  const auto steps = static_cast<size_t>(std::ceil(longest_s / period_s));
  for (size_t step = 0; step <= steps; ++step) {
    const double t = static_cast<double>(step) * period_s;
    PathPoint point;
    point.from_start_ns = static_cast<int64_t>(std::llround(t * 1e9));
    for (size_t i = 0; i < joints.size(); ++i) {
      const double speed = state.velocities[i];
      const double brake = std::copysign(max_deceleration[i], speed);
      const double stop_s = std::abs(speed) / max_deceleration[i];
      const bool moves = t < stop_s && std::abs(speed) > std::numeric_limits<float>::epsilon();
      const double braked_s = moves ? t : stop_s;
      point.positions.push_back(state.positions[i] + speed * braked_s -
                                brake * braked_s * braked_s / 2.0);
      point.velocities.push_back(moves ? speed - brake * t : 0.0);
      point.accelerations.push_back(moves ? -brake : 0.0);
    }
    request.points.push_back(std::move(point));
  }
  return request;
}

std::vector<size_t> mapping(const std::vector<std::string>& names,
                            const std::vector<std::string>& all) {
  std::vector<size_t> places;
  for (const std::string& name : names) {
    const auto found = std::find(all.begin(), all.end(), name);
    if (found == all.end()) return {};
    places.push_back(static_cast<size_t>(found - all.begin()));
  }
  return places;
}

void complete_and_sort(PathRequest& request, const std::vector<std::string>& joints,
                       const std::vector<double>& positions) {
  const auto add = [](std::vector<double>& values, double value) {
    if (!values.empty()) values.push_back(value);
  };
  for (size_t i = 0; i < joints.size(); ++i) {
    if (std::find(request.joints.begin(), request.joints.end(), joints[i]) !=
        request.joints.end()) {
      continue;
    }
    request.joints.push_back(joints[i]);
    for (PathPoint& point : request.points) {
      add(point.positions, positions[i]);
      add(point.velocities, 0.0);
      add(point.accelerations, 0.0);
      add(point.effort, 0.0);
    }
  }
  const std::vector<size_t> places = mapping(request.joints, joints);
  const auto sort = [&places](std::vector<double>& values) {
    if (values.size() != places.size()) return;
    std::vector<double> sorted(values.size());
    for (size_t i = 0; i < values.size(); ++i) sorted[places[i]] = values[i];
    values = std::move(sorted);
  };
  for (PathPoint& point : request.points) {
    sort(point.positions);
    sort(point.velocities);
    sort(point.accelerations);
    sort(point.effort);
  }
  request.joints = joints;
}

}  // namespace joint_trajectory_controller
