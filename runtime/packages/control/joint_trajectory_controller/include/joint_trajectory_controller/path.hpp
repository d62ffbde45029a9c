// A trajectory that is being run: what is wanted at a time. Knows nothing of ROS.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "joint_trajectory_controller/spline.hpp"

namespace joint_trajectory_controller {

enum class Interpolation : uint8_t { kNone, kSplines };

/// The points of a path that a time is between. Before the first point both are 0; after the last
/// one `end` is the number of points.
struct Segment {
  size_t begin = 0;
  size_t end = 0;
};

class Path {
 public:
  /// Starts another trajectory, which has points.
  void start(std::shared_ptr<PathRequest> request);
  [[nodiscard]] bool has_request() const { return request_ != nullptr; }
  [[nodiscard]] const std::shared_ptr<PathRequest>& request() const { return request_; }
  [[nodiscard]] bool is_sampled() const { return is_sampled_; }
  /// When it started, or will start; 0 before the first sample of one that starts at once.
  [[nodiscard]] int64_t start_ns() const { return start_ns_; }
  [[nodiscard]] int64_t time_of(size_t point) const {
    return start_ns_ + request_->points[point].from_start_ns;
  }
  [[nodiscard]] bool is_over(const Segment& segment) const {
    return segment.end == request_->points.size();
  }

  /// The state that the way to the first point starts from.
  void set_point_before(int64_t time_ns, const PathPoint& state, const std::vector<bool>& wraps);

  /// The state that is wanted at a time; nothing before set_point_before()'s time. A sample that
  /// does not only look (`only_looks`) forgets the segments before it.
  std::optional<Segment> sample(int64_t time_ns, Interpolation method, PathPoint& wanted,
                                bool only_looks = false);

 private:
  /// Fills in what points leave out.
  void deduce_points();

  std::shared_ptr<PathRequest> request_;
  int64_t start_ns_ = 0;
  int64_t before_ns_ = 0;
  PathPoint before_;
  bool is_sampled_ = false;
  size_t last_segment_ = 0;
};

/// A path that brakes at most at `max_deceleration` per joint, with a point per period.
PathRequest braking_path(const std::vector<std::string>& joints, const PathPoint& state,
                         const std::vector<double>& max_deceleration, double period_s);

/// Puts joints that the request does not name at the end, standing at `positions`, and then sorts
/// all into the order of `joints`.
void complete_and_sort(PathRequest& request, const std::vector<std::string>& joints,
                       const std::vector<double>& positions);

/// The place in `all` of each of `names`; empty when one of them is not there.
std::vector<size_t> mapping(const std::vector<std::string>& names,
                            const std::vector<std::string>& all);

}  // namespace joint_trajectory_controller
