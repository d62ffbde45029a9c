// A Kalman filter of the 15 variables: what an EKF and a UKF have in common. Without ROS.
#pragma once

#include <array>
#include <bitset>

#include "filter/measurement.hpp"

namespace robot_localization {

/// The estimate and all that a prediction starts from, so a copy can be restored.
struct FilterState {
  State mean = State::Zero();
  Covariance covariance = Covariance::Identity() * kLeastVariance;
  int64_t time_ns = 0;  ///< of the newest measurement, or of a prediction after it
  bool is_initialized = false;
  Control control;
};

/// How velocities follow the control. Each array is x, y, z, roll, pitch, yaw.
struct ControlModel {
  std::bitset<kTwistSize> axes;
  int64_t timeout_ns = 0;  ///< a control of this age counts as a stop
  std::array<double, kTwistSize> acceleration_limits{};
  std::array<double, kTwistSize> acceleration_gains{};
  std::array<double, kTwistSize> deceleration_limits{};
  std::array<double, kTwistSize> deceleration_gains{};
};

/// The noise of each second when a parameter file names none.
Covariance default_process_noise();

class Filter {
 public:
  virtual ~Filter() = default;

  void set_process_noise(const Covariance& noise) { process_noise_ = noise; }
  /// Noise of the pose grows with the square of the speed.
  void set_dynamic_process_noise(bool is_dynamic) { is_noise_dynamic_ = is_dynamic; }
  void set_control_model(const ControlModel& model) { control_model_ = model; }

  const FilterState& state() const { return state_; }
  void restore(const FilterState& state) { state_ = state; }
  void set_estimate(const State& mean, const Covariance& covariance);
  void set_time(int64_t time_ns) { state_.time_ns = time_ns; }
  void set_control(const Control& control) { state_.control = control; }

  /// Predicts up to the measurement, then corrects. The first one sets what it measures. One from
  /// before the filter's time only corrects.
  void process(const Measurement& measurement);
  /// Does nothing for a time that is not later than the filter's.
  void predict(int64_t time_ns);
  /// False when nothing of it can be used, or it is too far off.
  bool correct(const Measurement& measurement);

 protected:
  /// Moves the mean and the covariance of `state` by `dt` seconds and adds `noise`.
  virtual void project(FilterState& state, double dt, const Covariance& noise) const = 0;

 private:
  void begin_with(const Measurement& measurement);
  void apply_control(int64_t time_ns, double dt);
  Covariance noise_for(double dt) const;

  FilterState state_;
  Covariance process_noise_ = default_process_noise();
  bool is_noise_dynamic_ = false;
  ControlModel control_model_;
};

}  // namespace robot_localization
