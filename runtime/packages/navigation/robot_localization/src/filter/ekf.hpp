// The extended Kalman filter: the covariance follows the derivative of the motion.
#pragma once

#include "filter/filter.hpp"

namespace robot_localization {

class Ekf : public Filter {
 protected:
  void project(FilterState& state, double dt, const Covariance& noise) const override;
};

}  // namespace robot_localization
