// See filter.hpp.
#include "filter/filter.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace robot_localization {
namespace {

// Sizes are up to that of the state, so nothing is allocated.
using Rows = Eigen::Matrix<double, Eigen::Dynamic, kStateSize, 0, kStateSize, kStateSize>;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kStateSize, kStateSize>;
using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kStateSize, 1>;

/// The part of a measurement that can be used.
struct Subset {
  std::array<int, kStateSize> members{};
  int size = 0;
  Column values;
  Square covariance;
};

/// Leaves out what is not finite. Variances become positive, and cross covariances finite.
Subset usable(const Measurement& measurement) {
  Subset result;
  for (int i = 0; i < kStateSize; ++i) {
    const bool is_finite =
        std::isfinite(measurement.values(i)) && std::isfinite(measurement.covariance(i, i));
    if (measurement.update[i] && is_finite) result.members[result.size++] = i;
  }
  result.values.resize(result.size);
  result.covariance.resize(result.size, result.size);
  for (int i = 0; i < result.size; ++i) {
    const int row = result.members[i];
    result.values(i) = measurement.values(row);
    for (int j = 0; j < result.size; ++j) {
      const int column = result.members[j];
      const double both =
          (measurement.covariance(row, column) + measurement.covariance(column, row)) / 2.0;
      result.covariance(i, j) = std::isfinite(both) ? both : 0.0;
    }
    result.covariance(i, i) = std::max(std::abs(result.covariance(i, i)), kLeastVariance);
  }
  return result;
}

bool is_angle(int member) {
  return member == kRoll || member == kPitch || member == kYaw;
}

/// The innovation's covariance, decomposed. Cross covariances that no variables can have are
/// dropped.
Eigen::LDLT<Square> decomposed(const Square& predicted, Square& noise) {
  Eigen::LDLT<Square> result(predicted + noise);
  if (result.info() != Eigen::Success || !result.isPositive()) {
    noise = Square(noise.diagonal().asDiagonal());
    result.compute(predicted + noise);
  }
  return result;
}

/// Rounding makes the halves differ.
void make_symmetric(Covariance& covariance) {
  covariance = Covariance((covariance + covariance.transpose()) / 2.0);
}

double acceleration_towards(double wanted, double velocity, const ControlModel& model, int axis) {
  const double error = wanted - velocity;
  const bool is_same_direction = std::abs(error) <= std::abs(wanted) + 0.01;
  const double set_point = is_same_direction ? wanted : 0.0;
  const bool is_slowing = std::abs(set_point) < std::abs(velocity);
  const double gain = (is_slowing ? model.deceleration_gains : model.acceleration_gains)[axis];
  const double limit =
      std::abs((is_slowing ? model.deceleration_limits : model.acceleration_limits)[axis]);
  return std::clamp(gain * error, -limit, limit);
}

}  // namespace

Covariance default_process_noise() {
  State diagonal;
  diagonal << 0.05, 0.05, 0.06, 0.03, 0.03, 0.06, 0.025, 0.025, 0.04, 0.01, 0.01, 0.02, 0.01, 0.01,
      0.015;
  return diagonal.asDiagonal();
}

void Filter::set_estimate(const State& mean, const Covariance& covariance) {
  state_.mean = mean;
  state_.covariance = covariance;
}

void Filter::process(const Measurement& measurement) {
  if (!state_.is_initialized) {
    begin_with(measurement);
    return;
  }
  predict(measurement.time_ns);
  correct(measurement);
}

void Filter::begin_with(const Measurement& measurement) {
  const Subset subset = usable(measurement);
  if (subset.size == 0) return;
  for (int i = 0; i < subset.size; ++i) {
    state_.mean(subset.members[i]) = subset.values(i);
    for (int j = 0; j < subset.size; ++j) {
      state_.covariance(subset.members[i], subset.members[j]) = subset.covariance(i, j);
    }
  }
  wrap_angles(state_.mean);
  state_.time_ns = measurement.time_ns;
  state_.is_initialized = true;
}

void Filter::predict(int64_t time_ns) {
  if (time_ns <= state_.time_ns) return;
  const double dt = static_cast<double>(time_ns - state_.time_ns) * 1e-9;
  apply_control(time_ns, dt);
  project(state_, dt, noise_for(dt));
  make_symmetric(state_.covariance);
  wrap_angles(state_.mean);
  state_.time_ns = time_ns;
}

/// The control is an acceleration: along an axis it takes the place of the state's.
void Filter::apply_control(int64_t time_ns, double dt) {
  const bool is_old = time_ns - state_.control.time_ns >= control_model_.timeout_ns;
  for (int axis = 0; axis < kTwistSize; ++axis) {
    if (!control_model_.axes[axis]) continue;
    const double wanted = is_old ? 0.0 : state_.control.velocity(axis);
    const double acceleration =
        acceleration_towards(wanted, state_.mean(kVx + axis), control_model_, axis);
    if (axis < 3) {
      state_.mean(kAx + axis) = acceleration;
    } else {
      state_.mean(kVx + axis) += acceleration * dt;
    }
  }
}

Covariance Filter::noise_for(double dt) const {
  Covariance noise = process_noise_;
  if (is_noise_dynamic_) {
    noise.topLeftCorner<kPoseSize, kPoseSize>() *=
        state_.mean.segment<kTwistSize>(kVx).squaredNorm();
  }
  return noise * dt;
}

bool Filter::correct(const Measurement& measurement) {
  Subset subset = usable(measurement);
  if (subset.size == 0) return false;
  Rows measured_rows(subset.size, kStateSize);  // of the covariance
  Square predicted(subset.size, subset.size);
  Column innovation(subset.size);
  for (int i = 0; i < subset.size; ++i) {
    const int member = subset.members[i];
    measured_rows.row(i) = state_.covariance.row(member);
    for (int j = 0; j < subset.size; ++j) predicted(i, j) = measured_rows(i, subset.members[j]);
    innovation(i) = subset.values(i) - state_.mean(member);
    if (is_angle(member)) innovation(i) = wrapped(innovation(i));
  }
  const Eigen::LDLT<Square> solver = decomposed(predicted, subset.covariance);
  if (solver.info() != Eigen::Success || !solver.isPositive()) return false;
  const double distance_squared = innovation.dot(solver.solve(innovation));
  const double limit = measurement.rejection_threshold;
  if (!(distance_squared < limit * limit)) return false;

  const Rows gain = solver.solve(measured_rows);  // transposed
  const State mean = state_.mean + gain.transpose().lazyProduct(innovation);
  // Joseph's form: the covariance stays symmetric and positive also with rounding.
  Covariance rest = Covariance::Identity();
  for (int i = 0; i < subset.size; ++i) rest.col(subset.members[i]) -= gain.row(i).transpose();
  const Covariance half = rest.lazyProduct(state_.covariance);
  const Rows noisy_gain = subset.covariance.lazyProduct(gain);
  Covariance covariance = half.lazyProduct(rest.transpose());
  covariance += gain.transpose().lazyProduct(noisy_gain);
  if (!mean.allFinite() || !covariance.allFinite()) return false;  // too large a value
  state_.mean = mean;
  wrap_angles(state_.mean);
  state_.covariance = covariance;
  make_symmetric(state_.covariance);
  return true;
}

}  // namespace robot_localization
