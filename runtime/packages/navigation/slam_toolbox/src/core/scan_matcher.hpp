// Finds the pose at which a scan fits best to scans whose poses are known.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/correlation_grid.hpp"
#include "core/scan.hpp"

namespace slam_toolbox {

/// Where a matcher searches, and on which raster.
struct SearchSpace {
  double dimension = 0.5;        ///< [m], of the square around the guess
  double resolution = 0.01;      ///< [m]
  double smear_deviation = 0.1;  ///< [m]
};

struct MatcherSettings {
  double distance_variance_penalty = 0.5;     ///< [m^2]
  double angle_variance_penalty = 1.0;        ///< [rad^2]
  double fine_search_angle_offset = 0.00349;  ///< [rad], as the next
  double coarse_search_angle_offset = 0.349;
  double coarse_angle_resolution = 0.0349;
  double minimum_angle_penalty = 0.9;
  double minimum_distance_penalty = 0.05;
  bool use_response_expansion = true;
};

struct Match {
  Pose pose;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  double response = 0.0;  ///< 0 to 1: how many of the rays end on obstacles
};

class ScanMatcher {
 public:
  ScanMatcher(const SearchSpace& space, const MatcherSettings& settings);

  /// `penalize`: poses far from the guess count less. `refine`: a second search in small steps.
  Match match(const Scan& scan, const Pose& guess, const std::vector<const Scan*>& base,
              bool penalize = true, bool refine = true);

 private:
  /// Offsets from a pose, in steps.
  struct Search {
    double reach;       ///< [m]
    double step;        ///< [m]
    double angle;       ///< [rad]
    double angle_step;  ///< [rad]
    bool penalize;
    bool is_coarse;
  };
  struct Responses;

  bool draw(const Scan& scan, const Pose& guess, const std::vector<const Scan*>& base);
  Match search(const Scan& scan, const Pose& centre, const Search& search) const;
  double penalty(double squared_distance, double angle) const;

  SearchSpace space_;
  MatcherSettings settings_;
  CorrelationGrid grid_;
  std::vector<Point> seen_;
};

}  // namespace slam_toolbox
