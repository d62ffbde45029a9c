// How likely a laser scan is at the pose of each particle: three models. Without ROS.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "nav2_amcl/map/occupancy_map.hpp"
#include "nav2_amcl/pf/particle_filter.hpp"

namespace nav2_amcl {

struct Beam {
  double range;    // m; range_max and more when nothing was seen, NaN when it was not measured
  double bearing;  // rad, in the frame of the robot
};

struct LaserData {
  double range_max = 0.0;  // m, positive
  std::vector<Beam> beams;
};

struct LaserSettings {
  int max_beams = 60;
  double z_hit = 0.5;
  double z_short = 0.05;
  double z_max = 0.05;
  double z_rand = 0.5;
  double sigma_hit = 0.2;            // m
  double lambda_short = 0.1;         // 1/m
  double likelihood_max_dist = 2.0;  // m
  bool do_beamskip = false;
  double beam_skip_distance = 0.5;         // m
  double beam_skip_threshold = 0.3;        // share of the particles
  double beam_skip_error_threshold = 0.9;  // share of the beams
};

class LaserModel {
 public:
  virtual ~LaserModel() = default;
  /// Multiplies the weights by the likelihood of a scan. False, and nothing is changed, when
  /// `max_beams` is below 2.
  bool weigh(const LaserData& data, Particles& particles, bool is_converged);

 protected:
  LaserModel(const LaserSettings& settings, std::shared_ptr<const OccupancyMap> map,
             const pf_vector_t& laser_pose);
  virtual void weigh_beams(const LaserData& data, Particles& particles, bool is_converged) = 0;

  /// Every so many beams are used by the models that raise likelihoods to the third power.
  size_t step_of(const LaserData& data) const;

  LaserSettings settings_;
  std::shared_ptr<const OccupancyMap> map_;
  pf_vector_t laser_pose_;  // in the frame of the robot; its yaw is in the bearings
};

/// `type` is `beam`, `likelihood_field_prob`, or any other word for the likelihood field.
/// `laser_pose` is relative to the robot.
std::unique_ptr<LaserModel> make_laser_model(const std::string& type, const LaserSettings& settings,
                                             const std::shared_ptr<OccupancyMap>& map,
                                             const pf_vector_t& laser_pose);

}  // namespace nav2_amcl
