// See update_functions.hpp.
#include "diagnostic_updater/update_functions.hpp"

#include <algorithm>
#include <cmath>

namespace diagnostic_updater {

FrequencyStatus::FrequencyStatus(const FrequencyStatusParam& params, std::string name,
                                 const rclcpp::Clock::SharedPtr clock)
    : DiagnosticTask(name), params_(params), clock_(clock) {
  clear();
}

void FrequencyStatus::clear() {
  const std::lock_guard<std::mutex> lock(lock_);
  count_ = 0;
  windows_.assign(static_cast<size_t>(params_.window_size_), {clock_->now(), 0});
}

void FrequencyStatus::tick() {
  const std::lock_guard<std::mutex> lock(lock_);
  ++count_;
}

void FrequencyStatus::run(DiagnosticStatusWrapper& stat) {
  const std::lock_guard<std::mutex> lock(lock_);
  const rclcpp::Time now = clock_->now();
  const int events = count_ - windows_.front().count;
  const double window = (now - windows_.front().start).seconds();
  const double freq = events / window;
  windows_.pop_front();
  windows_.push_back({now, count_});

  if (events == 0) {
    stat.summary(stat.ERROR, "No events recorded.");
  } else if (freq < *params_.min_freq_ * (1 - params_.tolerance_)) {
    stat.summary(stat.WARN, "Frequency too low.");
  } else if (freq > *params_.max_freq_ * (1 + params_.tolerance_)) {
    stat.summary(stat.WARN, "Frequency too high.");
  } else {
    stat.summary(stat.OK, "Desired frequency met");
  }
  stat.addf("Events in window", "%d", events);
  stat.addf("Events since startup", "%d", count_);
  stat.addf("Duration of window (s)", "%f", window);
  stat.addf("Actual frequency (Hz)", "%f", freq);
  if (*params_.min_freq_ == *params_.max_freq_) {
    stat.addf("Target frequency (Hz)", "%f", *params_.min_freq_);
  }
  if (*params_.min_freq_ > 0) {
    stat.addf("Minimum acceptable frequency (Hz)", "%f",
              *params_.min_freq_ * (1 - params_.tolerance_));
  }
  if (std::isfinite(*params_.max_freq_)) {
    stat.addf("Maximum acceptable frequency (Hz)", "%f",
              *params_.max_freq_ * (1 + params_.tolerance_));
  }
}

void TimeStampStatus::tick(double stamp) {
  const std::lock_guard<std::mutex> lock(lock_);
  if (stamp == 0) {
    zero_seen_ = true;
    return;
  }
  const double delta = clock_->now().seconds() - stamp;
  max_delta_ = deltas_valid_ ? std::max(max_delta_, delta) : delta;
  min_delta_ = deltas_valid_ ? std::min(min_delta_, delta) : delta;
  deltas_valid_ = true;
}

void TimeStampStatus::run(DiagnosticStatusWrapper& stat) {
  const std::lock_guard<std::mutex> lock(lock_);
  stat.summary(stat.OK, "Timestamps are reasonable.");
  if (!deltas_valid_) {
    stat.summary(stat.WARN, "No data since last update.");
  } else {
    if (min_delta_ < params_.min_acceptable_) {
      stat.summary(stat.ERROR, "Timestamps too far in future seen.");
      ++early_count_;
    }
    if (max_delta_ > params_.max_acceptable_) {
      stat.summary(stat.ERROR, "Timestamps too far in past seen.");
      ++late_count_;
    }
    if (zero_seen_) {
      stat.summary(stat.ERROR, "Zero timestamp seen.");
      ++zero_count_;
    }
  }
  stat.addf("Earliest timestamp delay", "%f", min_delta_);
  stat.addf("Latest timestamp delay", "%f", max_delta_);
  stat.addf("Earliest acceptable timestamp delay", "%f", params_.min_acceptable_);
  stat.addf("Latest acceptable timestamp delay", "%f", params_.max_acceptable_);
  stat.add("Late diagnostic update count", late_count_);
  stat.add("Early diagnostic update count", early_count_);
  stat.add("Zero seen diagnostic update count", zero_count_);
  deltas_valid_ = false;
  zero_seen_ = false;
  min_delta_ = 0;
  max_delta_ = 0;
}

}  // namespace diagnostic_updater
