// Brings measurements into the order of their times and gives them to a filter. With a history, one
// that comes late is taken in where it belongs. Without ROS.
#pragma once

#include <deque>
#include <map>
#include <memory>

#include "filter/filter.hpp"

namespace robot_localization {

struct EstimatorSettings {
  bool smooth_lagged_data = false;
  int64_t history_length_ns = 0;
  int64_t sensor_timeout_ns = 33'333'333;  ///< without measurements for so long, predict
  bool predict_to_current_time = false;
};

class Estimator {
 public:
  /// Entries of the queue and of the history, 2 kB each: a bound on the memory that stamps can
  /// cost.
  static constexpr size_t kMostEntries = 10'000;

  explicit Estimator(std::unique_ptr<Filter> filter) : filter_(std::move(filter)) {}

  Filter& filter() { return *filter_; }
  const FilterState& state() const { return filter_->state(); }
  void set_settings(const EstimatorSettings& settings) { settings_ = settings; }

  /// False when the queue is full: measurements of the future wait there for their time.
  bool add(Measurement measurement);
  /// Takes in all measurements up to `now_ns`.
  void integrate(int64_t now_ns);
  /// Forgets measurements that wait.
  void clear_queue() { queue_.clear(); }
  /// Forgets the past too, as after a jump of the pose.
  void clear();

 private:
  /// Goes back to the newest known state before that time; what came after it waits again. Without
  /// such a state, goes back to the oldest. False without a history.
  bool revert_before(int64_t time_ns);
  void remember(Measurement measurement);
  void drop_expired();

  std::unique_ptr<Filter> filter_;
  EstimatorSettings settings_;
  std::multimap<int64_t, Measurement> queue_;  ///< by time; equal times in the order of arrival
  std::deque<FilterState> states_;        ///< one for each time at which there was a measurement
  std::deque<Measurement> measurements_;  ///< that the states are from
};

}  // namespace robot_localization
