// See estimator.hpp.
#include "filter/estimator.hpp"

#include <iterator>
#include <utility>

namespace robot_localization {

bool Estimator::add(Measurement measurement) {
  const int64_t time_ns = measurement.time_ns;
  queue_.emplace(time_ns, std::move(measurement));
  if (queue_.size() <= kMostEntries) return true;
  queue_.erase(std::prev(queue_.end()));
  return false;
}

void Estimator::clear() {
  queue_.clear();
  states_.clear();
  measurements_.clear();
}

void Estimator::integrate(int64_t now_ns) {
  const Control newest = state().control;
  bool should_predict = settings_.predict_to_current_time;
  bool is_replay = false;
  if (queue_.empty() || queue_.begin()->first > now_ns) {
    should_predict |= now_ns - state().time_ns >= settings_.sensor_timeout_ns;
  } else if (settings_.smooth_lagged_data && state().is_initialized &&
             queue_.begin()->first < state().time_ns) {
    is_replay = revert_before(queue_.begin()->first);
  }
  while (!queue_.empty() && queue_.begin()->first <= now_ns) {
    Measurement measurement = std::move(queue_.extract(queue_.begin()).mapped());
    if (is_replay) filter_->set_control(measurement.control);
    filter_->process(measurement);
    if (settings_.smooth_lagged_data) remember(std::move(measurement));
  }
  filter_->set_control(newest);
  if (should_predict && state().is_initialized) filter_->predict(now_ns);
  drop_expired();
}

void Estimator::remember(Measurement measurement) {
  measurements_.push_back(std::move(measurement));
  if (queue_.empty() || queue_.begin()->first != state().time_ns) states_.push_back(state());
}

bool Estimator::revert_before(int64_t time_ns) {
  if (states_.empty()) return false;
  while (states_.size() > 1 && states_.back().time_ns >= time_ns) states_.pop_back();
  filter_->restore(states_.back());
  while (!measurements_.empty() && measurements_.back().time_ns > state().time_ns) {
    const int64_t measured_ns = measurements_.back().time_ns;
    // In front of others of its time: it is taken from the back of the history.
    queue_.emplace_hint(queue_.lower_bound(measured_ns), measured_ns,
                        std::move(measurements_.back()));
    measurements_.pop_back();
  }
  return true;
}

void Estimator::drop_expired() {
  const int64_t oldest_ns = state().time_ns - settings_.history_length_ns;
  while (!measurements_.empty() &&
         (measurements_.front().time_ns < oldest_ns || measurements_.size() > kMostEntries)) {
    measurements_.pop_front();
  }
  while (!states_.empty() &&
         (states_.front().time_ns < oldest_ns || states_.size() > kMostEntries)) {
    states_.pop_front();
  }
}

}  // namespace robot_localization
