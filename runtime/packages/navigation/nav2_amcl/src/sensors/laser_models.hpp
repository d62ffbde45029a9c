// The three models behind make_laser_model().
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "nav2_amcl/sensors/laser_model.hpp"

namespace nav2_amcl {

/// Compares each range with the one that the map gives.
class BeamModel : public LaserModel {
 public:
  BeamModel(const LaserSettings& settings, std::shared_ptr<const OccupancyMap> map,
            const pf_vector_t& laser_pose)
      : LaserModel(settings, std::move(map), laser_pose) {}

 protected:
  void weigh_beams(const LaserData& data, Particles& particles, bool is_converged) override;

 private:
  double likelihood(double seen, double expected, double range_max) const;
};

/// Asks how far the end of each beam is from something occupied.
class FieldModel : public LaserModel {
 protected:
  /// Where a beam ends in the frame of the robot, in m.
  struct End {
    double x;
    double y;
  };

  FieldModel(const LaserSettings& settings, std::shared_ptr<const OccupancyMap> map,
             const pf_vector_t& laser_pose);
  /// Beams that saw nothing have no end.
  bool has_end(const Beam& beam, double range_max) const { return beam.range < range_max; }
  End end_of(const Beam& beam) const;
  /// The distance [m] from the end to something occupied for a robot at a pose.
  double distance_at(const pf_vector_t& pose, double cos_yaw, double sin_yaw, const End& end) const;
  double likelihood(double distance) const;

 private:
  double denominator_;  // m^2
};

class LikelihoodFieldModel : public FieldModel {
 public:
  LikelihoodFieldModel(const LaserSettings& settings, std::shared_ptr<const OccupancyMap> map,
                       const pf_vector_t& laser_pose)
      : FieldModel(settings, std::move(map), laser_pose) {}

 protected:
  void weigh_beams(const LaserData& data, Particles& particles, bool is_converged) override;
};

/// Multiplies the likelihoods of beams. It can skip beams on which most particles agree that the
/// map has nothing there.
class LikelihoodFieldModelProb : public FieldModel {
 public:
  LikelihoodFieldModelProb(const LaserSettings& settings, std::shared_ptr<const OccupancyMap> map,
                           const pf_vector_t& laser_pose)
      : FieldModel(settings, std::move(map), laser_pose) {}

 protected:
  void weigh_beams(const LaserData& data, Particles& particles, bool is_converged) override;

 private:
  /// Which beams count, by how many particles find something near their ends.
  std::vector<bool> beams_that_count(const std::vector<int>& agreeing, size_t particles) const;
};

}  // namespace nav2_amcl
