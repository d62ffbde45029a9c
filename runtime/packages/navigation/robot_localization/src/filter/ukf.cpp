// See ukf.hpp.
#include "filter/ukf.hpp"

#include <Eigen/Cholesky>

#include "filter/motion_model.hpp"

namespace robot_localization {
namespace {

/// A matrix whose product with its transpose is the covariance. Negative parts count as zero.
Covariance square_root(const Covariance& covariance) {
  const Eigen::LDLT<Covariance> parts(covariance);
  const State scale = parts.vectorD().cwiseMax(0.0).cwiseSqrt();
  Covariance root = parts.matrixL();
  for (int i = 0; i < kStateSize; ++i) root.col(i) *= scale(i);
  return parts.transpositionsP().transpose() * root;
}

State difference(const State& left, const State& right) {
  State result = left - right;
  wrap_angles(result);
  return result;
}

}  // namespace

bool Ukf::set_constants(double alpha, double kappa, double beta) {
  const double spread = alpha * alpha * (kStateSize + kappa);
  if (!(spread > 0.0) || !std::isfinite(spread) || !std::isfinite(beta)) return false;
  spread_ = spread;
  alpha_ = alpha;
  beta_ = beta;
  return true;
}

void Ukf::project(FilterState& state, double dt, const Covariance& noise) const {
  const Covariance offsets = square_root(state.covariance * spread_);
  const double weight = 1.0 / (2.0 * spread_);
  const State center = advanced(state.mean, dt);
  std::array<State, 2 * kStateSize> points;
  // The weights add up to 1, and that of the centre is large and negative: the mean is the centre
  // plus differences, which loses no digits.
  State shift = State::Zero();
  for (int i = 0; i < kStateSize; ++i) {
    points[i] = advanced(state.mean + offsets.col(i), dt);
    points[kStateSize + i] = advanced(state.mean - offsets.col(i), dt);
    shift += difference(points[i], center) + difference(points[kStateSize + i], center);
  }
  state.mean = center + shift * weight;

  const auto add = [&state](const State& deviation, double share) {
    state.covariance += (deviation * share).lazyProduct(deviation.transpose());
  };
  state.covariance = noise;
  const double first_weight = 1.0 - kStateSize / spread_ + 1.0 - alpha_ * alpha_ + beta_;
  add(difference(center, state.mean), first_weight);
  for (const State& point : points) add(difference(point, state.mean), weight);
}

}  // namespace robot_localization
