// See laser_models.hpp.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

#include "laser_models.hpp"

namespace nav2_amcl {

FieldModel::FieldModel(const LaserSettings& settings, std::shared_ptr<const OccupancyMap> map,
                       const pf_vector_t& laser_pose)
    : LaserModel(settings, std::move(map), laser_pose),
      denominator_(2 * settings.sigma_hit * settings.sigma_hit) {}

FieldModel::End FieldModel::end_of(const Beam& beam) const {
  return {laser_pose_.v[0] + beam.range * std::cos(beam.bearing),
          laser_pose_.v[1] + beam.range * std::sin(beam.bearing)};
}

double FieldModel::distance_at(const pf_vector_t& pose, double cos_yaw, double sin_yaw,
                               const End& end) const {
  const std::optional<size_t> cell = map_->cell_at(pose.v[0] + end.x * cos_yaw - end.y * sin_yaw,
                                                   pose.v[1] + end.x * sin_yaw + end.y * cos_yaw);
  return cell ? static_cast<double>(map_->distance(*cell)) : map_->max_distance();
}

double FieldModel::likelihood(double distance) const {
  return settings_.z_hit * std::exp(-(distance * distance) / denominator_);
}

void LikelihoodFieldModel::weigh_beams(const LaserData& data, Particles& particles, bool) {
  const double random = settings_.z_rand / data.range_max;
  const size_t step = step_of(data);
  std::vector<End> ends;
  for (size_t i = 0; i < data.beams.size(); i += step) {
    if (has_end(data.beams[i], data.range_max)) ends.push_back(end_of(data.beams[i]));
  }
  for (pf_sample_t& particle : particles) {
    const double c = std::cos(particle.pose.v[2]);
    const double s = std::sin(particle.pose.v[2]);
    double factor = 1.0;
    for (const End& end : ends) {
      const double p = likelihood(distance_at(particle.pose, c, s, end)) + random;
      factor += p * p * p;
    }
    particle.weight *= factor;
  }
}

std::vector<bool> LikelihoodFieldModelProb::beams_that_count(const std::vector<int>& agreeing,
                                                             size_t particles) const {
  std::vector<bool> counts;
  const auto most = static_cast<size_t>(settings_.max_beams);
  // Beams that saw nothing agree with nothing either.
  size_t skipped = most - std::min(most, agreeing.size());
  for (const int number : agreeing) {
    counts.push_back(number > settings_.beam_skip_threshold * static_cast<double>(particles));
    if (!counts.back()) ++skipped;
  }
  const double limit = settings_.max_beams * settings_.beam_skip_error_threshold;
  if (static_cast<double>(skipped) < limit) return counts;
  std::fprintf(stderr,
               "Over %f%% of the observations were not in the map - pf may have converged to wrong "
               "pose - integrating all observations\n",
               100 * settings_.beam_skip_error_threshold);
  return std::vector<bool>(agreeing.size(), true);
}

void LikelihoodFieldModelProb::weigh_beams(const LaserData& data, Particles& particles,
                                           bool is_converged) {
  const double random = settings_.z_rand / data.range_max;
  const auto most = static_cast<size_t>(settings_.max_beams);
  const size_t step = std::max<size_t>(1, (data.beams.size() + most - 1) / most);
  // Particles that are spread disagree about beams for other reasons than obstacles.
  const bool skips = settings_.do_beamskip && is_converged;
  std::vector<End> ends;
  for (size_t i = 0; i < data.beams.size(); i += step) {
    if (has_end(data.beams[i], data.range_max)) ends.push_back(end_of(data.beams[i]));
  }
  std::vector<int> agreeing(ends.size(), 0);
  std::vector<double> logarithms(skips ? ends.size() * particles.size() : 0);
  for (size_t j = 0; j < particles.size(); ++j) {
    pf_sample_t& particle = particles[j];
    const double c = std::cos(particle.pose.v[2]);
    const double s = std::sin(particle.pose.v[2]);
    double sum = 0.0;
    for (size_t i = 0; i < ends.size(); ++i) {
      const double distance = distance_at(particle.pose, c, s, ends[i]);
      const double logarithm = std::log(likelihood(distance) + random);
      sum += logarithm;
      if (!skips) continue;
      if (distance < settings_.beam_skip_distance) ++agreeing[i];
      logarithms[j * ends.size() + i] = logarithm;
    }
    if (!skips) particle.weight *= std::exp(sum);
  }
  if (!skips) return;
  const std::vector<bool> counts = beams_that_count(agreeing, particles.size());
  for (size_t j = 0; j < particles.size(); ++j) {
    double sum = 0.0;
    for (size_t i = 0; i < ends.size(); ++i) {
      if (counts[i]) sum += logarithms[j * ends.size() + i];
    }
    particles[j].weight *= std::exp(sum);
  }
}

}  // namespace nav2_amcl
