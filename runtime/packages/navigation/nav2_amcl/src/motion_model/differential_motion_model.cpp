// See differential_motion_model.hpp.
#include "nav2_amcl/motion_model/differential_motion_model.hpp"

#include <algorithm>
#include <cmath>

#include "nav2_amcl/angleutils.hpp"

namespace nav2_amcl {
namespace {

// A shorter way has no direction that can be relied on: the robot turned on the spot.
constexpr double kLeastTranslation = 0.01;  // m

double square(double value) {
  return value * value;
}

/// Driving backward is as exact as driving forward.
double turn_for_noise(double turn) {
  return std::min(std::abs(angleutils::angle_diff(turn, 0.0)),
                  std::abs(angleutils::angle_diff(turn, M_PI)));
}

}  // namespace

void DifferentialMotionModel::initialize(double alpha1, double alpha2, double alpha3, double alpha4,
                                         double) {
  alpha1_ = alpha1;
  alpha2_ = alpha2;
  alpha3_ = alpha3;
  alpha4_ = alpha4;
}

void DifferentialMotionModel::odometryUpdate(pf_t* pf, const pf_vector_t& pose,
                                             const pf_vector_t& delta) {
  const double way = std::hypot(delta.v[0], delta.v[1]);
  const double old_yaw = pose.v[2] - delta.v[2];
  const double first = way < kLeastTranslation
                           ? 0.0
                           : angleutils::angle_diff(std::atan2(delta.v[1], delta.v[0]), old_yaw);
  const double second = angleutils::angle_diff(delta.v[2], first);
  const double first_noise = square(turn_for_noise(first));
  const double second_noise = square(turn_for_noise(second));
  const double first_sigma = std::sqrt(alpha1_ * first_noise + alpha2_ * square(way));
  const double second_sigma = std::sqrt(alpha1_ * second_noise + alpha2_ * square(way));
  const double way_sigma =
      std::sqrt(alpha3_ * square(way) + alpha4_ * (first_noise + second_noise));

  pf_sample_set_t& set = pf->sets[pf->current_set];
  for (int i = 0; i < set.sample_count; ++i) {
    auto& particle = set.samples[i].pose.v;
    const double turn = angleutils::angle_diff(first, pf_ran_gaussian(first_sigma));
    const double length = way - pf_ran_gaussian(way_sigma);
    const double last_turn = angleutils::angle_diff(second, pf_ran_gaussian(second_sigma));
    particle[0] += length * std::cos(particle[2] + turn);
    particle[1] += length * std::sin(particle[2] + turn);
    particle[2] += turn + last_turn;
  }
}

}  // namespace nav2_amcl
