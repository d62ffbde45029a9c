// See ekf.hpp.
#include "filter/ekf.hpp"

#include "filter/motion_model.hpp"

namespace robot_localization {

void Ekf::project(FilterState& state, double dt, const Covariance& noise) const {
  const Covariance jacobian = advance_jacobian(state.mean, dt);
  const Covariance half = jacobian.lazyProduct(state.covariance);
  state.covariance = half.lazyProduct(jacobian.transpose());
  state.covariance += noise;
  state.mean = advanced(state.mean, dt);
}

}  // namespace robot_localization
