// One reading of a sensor, as the filter takes it: some variables of the state, with their
// covariance.
#pragma once

#include <limits>
#include <string>

#include "filter/state.hpp"

namespace robot_localization {

/// The velocity that was asked for, in the frame of the base.
struct Control {
  Vector6 velocity = Vector6::Zero();  ///< [m/s, rad/s]
  int64_t time_ns = 0;
};

struct Measurement {
  std::string source;  ///< "odom0_pose"
  int64_t time_ns = 0;
  State values = State::Zero();
  Covariance covariance = Covariance::Zero();
  Variables update;  ///< only these variables are measured
  /// In standard deviations: a value further off is rejected.
  double rejection_threshold = std::numeric_limits<double>::max();
  Control control;  ///< the newest when it came, for a replay
};

}  // namespace robot_localization
