// How a body moves for a short time: the velocities turn and move the pose, accelerations are
// constant.
#pragma once

#include "filter/state.hpp"

namespace robot_localization {

/// The state after `dt` seconds. Angles are not wrapped.
State advanced(const State& state, double dt);

/// The derivative of `advanced` by the state.
Covariance advance_jacobian(const State& state, double dt);

}  // namespace robot_localization
