// See omni_motion_model.hpp.
#include "nav2_amcl/motion_model/omni_motion_model.hpp"

#include <cmath>

#include "nav2_amcl/angleutils.hpp"

namespace nav2_amcl {

void OmniMotionModel::initialize(double alpha1, double alpha2, double alpha3, double alpha4,
                                 double alpha5) {
  alpha1_ = alpha1;
  alpha2_ = alpha2;
  alpha3_ = alpha3;
  alpha4_ = alpha4;
  alpha5_ = alpha5;
}

void OmniMotionModel::odometryUpdate(pf_t* pf, const pf_vector_t& pose, const pf_vector_t& delta) {
  const double way = std::hypot(delta.v[0], delta.v[1]);
  const double turn = delta.v[2];
  const double way_square = way * way;
  const double turn_square = turn * turn;
  const double way_sigma = std::sqrt(alpha3_ * way_square + alpha4_ * turn_square);
  const double turn_sigma = std::sqrt(alpha1_ * turn_square + alpha2_ * way_square);
  const double strafe_sigma = std::sqrt(alpha4_ * turn_square + alpha5_ * way_square);
  const double bearing =
      angleutils::angle_diff(std::atan2(delta.v[1], delta.v[0]), pose.v[2] - turn);

  pf_sample_set_t& set = pf->sets[pf->current_set];
  for (int i = 0; i < set.sample_count; ++i) {
    auto& particle = set.samples[i].pose.v;
    const double c = std::cos(bearing + particle[2]);
    const double s = std::sin(bearing + particle[2]);
    const double length = way + pf_ran_gaussian(way_sigma);
    const double change = turn + pf_ran_gaussian(turn_sigma);
    const double strafe = pf_ran_gaussian(strafe_sigma);
    particle[0] += length * c + strafe * s;
    particle[1] += length * s - strafe * c;
    particle[2] += change;
  }
}

}  // namespace nav2_amcl
