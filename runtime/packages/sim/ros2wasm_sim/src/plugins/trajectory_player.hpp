// Goes through the points of a trajectory by their times. Nothing is interpolated.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ros2wasm_sim {

class TrajectoryPlayer {
 public:
  /// `until_ns` are the times of the points from the start of the trajectory.
  void begin(std::vector<std::int64_t> until_ns, std::int64_t start_ns) {
    until_ns_ = std::move(until_ns);
    start_ns_ = start_ns;
    next_ = 0;
    is_fresh_ = !until_ns_.empty();
  }

  /// True when another point begins, or the last one has ended. A point holds until its time has
  /// passed.
  bool advance(std::int64_t now_ns) {
    if (now_ns < start_ns_) return false;
    bool changed = std::exchange(is_fresh_, false);
    while (next_ < until_ns_.size() && until_ns_[next_] < now_ns - start_ns_) {
      ++next_;
      changed = true;
    }
    return changed;
  }

  bool is_over() const { return next_ >= until_ns_.size(); }
  std::size_t point() const { return next_; }  ///< that holds now, unless it is over
  double progress() const {
    return until_ns_.empty() ? 1
                             : static_cast<double>(next_) / static_cast<double>(until_ns_.size());
  }

 private:
  std::vector<std::int64_t> until_ns_;
  std::int64_t start_ns_ = 0;
  std::size_t next_ = 0;
  bool is_fresh_ = false;
};

}  // namespace ros2wasm_sim
