// See laser_models.hpp.
#include <cmath>

#include "laser_models.hpp"

namespace nav2_amcl {

double BeamModel::likelihood(double seen, double expected, double range_max) const {
  const double error = seen - expected;
  double p = settings_.z_hit *
             std::exp(-(error * error) / (2 * settings_.sigma_hit * settings_.sigma_hit));
  // Something that the map does not have is in the way.
  if (error < 0) {
    p += settings_.z_short * settings_.lambda_short * std::exp(-settings_.lambda_short * seen);
  }
  if (seen == range_max) p += settings_.z_max;
  if (seen < range_max) p += settings_.z_rand / range_max;
  return p;
}

void BeamModel::weigh_beams(const LaserData& data, Particles& particles, bool) {
  const size_t step = step_of(data);
  for (pf_sample_t& particle : particles) {
    const pf_vector_t pose = pf_vector_coord_add(laser_pose_, particle.pose);
    double factor = 1.0;
    for (size_t i = 0; i < data.beams.size(); i += step) {
      const Beam& beam = data.beams[i];
      if (std::isnan(beam.range)) continue;
      const double expected =
          map_->range(pose.v[0], pose.v[1], pose.v[2] + beam.bearing, data.range_max);
      const double p = likelihood(beam.range, expected, data.range_max);
      factor += p * p * p;
    }
    particle.weight *= factor;
  }
}

}  // namespace nav2_amcl
