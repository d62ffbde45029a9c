// Tasks that many nodes need: how often something happens, and how old its stamps are.
#pragma once

#include <deque>
#include <mutex>
#include <string>

#include "diagnostic_updater/diagnostic_updater.hpp"

namespace diagnostic_updater {

/// The limits [Hz] belong to the caller, who may change them.
struct FrequencyStatusParam {
  FrequencyStatusParam(double* min_freq, double* max_freq, double tolerance = 0.1,
                       int window_size = 5)
      : min_freq_(min_freq),
        max_freq_(max_freq),
        tolerance_(tolerance),
        window_size_(window_size) {}

  double* min_freq_;
  double* max_freq_;
  double tolerance_;
  int window_size_;  ///< updates
};

class FrequencyStatus : public DiagnosticTask {
 public:
  FrequencyStatus(const FrequencyStatusParam& params, std::string name,
                  const rclcpp::Clock::SharedPtr clock = std::make_shared<rclcpp::Clock>());
  explicit FrequencyStatus(const FrequencyStatusParam& params,
                           const rclcpp::Clock::SharedPtr clock = std::make_shared<rclcpp::Clock>())
      : FrequencyStatus(params, "Frequency Status", clock) {}

  void clear();
  void tick();
  void run(DiagnosticStatusWrapper& stat) override;

 private:
  struct Window {
    rclcpp::Time start;
    int count;  ///< ticks before it
  };

  const FrequencyStatusParam params_;
  int count_ = 0;
  std::deque<Window> windows_;
  std::mutex lock_;
  rclcpp::Clock::SharedPtr clock_;
};

struct TimeStampStatusParam {
  TimeStampStatusParam(const double min_acceptable = -1, const double max_acceptable = 5)
      : max_acceptable_(max_acceptable), min_acceptable_(min_acceptable) {}

  double max_acceptable_;  ///< s that a stamp may be old
  double min_acceptable_;
};

class TimeStampStatus : public DiagnosticTask {
 public:
  TimeStampStatus(const TimeStampStatusParam& params, std::string name,
                  const rclcpp::Clock::SharedPtr clock = std::make_shared<rclcpp::Clock>())
      : DiagnosticTask(name), params_(params), clock_(clock) {}
  explicit TimeStampStatus(const TimeStampStatusParam& params,
                           const rclcpp::Clock::SharedPtr clock = std::make_shared<rclcpp::Clock>())
      : TimeStampStatus(params, "Timestamp Status", clock) {}
  explicit TimeStampStatus(const rclcpp::Clock::SharedPtr clock = std::make_shared<rclcpp::Clock>())
      : TimeStampStatus(TimeStampStatusParam(), clock) {}

  void tick(double stamp);
  void tick(const rclcpp::Time t) { tick(t.seconds()); }
  void run(DiagnosticStatusWrapper& stat) override;

 private:
  const TimeStampStatusParam params_;
  int early_count_ = 0;
  int late_count_ = 0;
  int zero_count_ = 0;
  bool zero_seen_ = false;
  double max_delta_ = 0;
  double min_delta_ = 0;
  bool deltas_valid_ = false;
  std::mutex lock_;
  rclcpp::Clock::SharedPtr clock_;
};

/// Says that the node runs.
class Heartbeat : public DiagnosticTask {
 public:
  Heartbeat() : DiagnosticTask("Heartbeat") {}
  void run(DiagnosticStatusWrapper& stat) override { stat.summary(stat.OK, "Alive"); }
};

}  // namespace diagnostic_updater
