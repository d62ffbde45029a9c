// The unscented Kalman filter: points around the mean move, and the estimate is made of them again.
// A correction needs no points: what is measured are entries of the state, so points would give
// the same gain as the covariance itself.
#pragma once

#include "filter/filter.hpp"

namespace robot_localization {

class Ukf : public Filter {
 public:
  /// alpha and kappa are the spread of the points; beta is 2 for Gaussian noise. False when the
  /// points would have no spread: alpha^2 (15 + kappa) must be positive.
  bool set_constants(double alpha, double kappa, double beta);

 protected:
  void project(FilterState& state, double dt, const Covariance& noise) const override;

 private:
  double spread_ = 1e-6 * kStateSize;  ///< of the points, in variances
  double alpha_ = 0.001;
  double beta_ = 2.0;
};

}  // namespace robot_localization
