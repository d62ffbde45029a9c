// Monte Carlo localization with as many particles as the spread of the poses needs (KLD sampling).
// Without ROS. All random numbers come from the generator that a filter is made with.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "nav2_amcl/motion_model/motion_model.hpp"
#include "nav2_amcl/pf/pf.hpp"
#include "nav2_amcl/pf/pose_bins.hpp"
#include "nav2_amcl/pf/random.hpp"

namespace nav2_amcl {

struct FilterSettings {
  int min_particles = 500;
  int max_particles = 2000;
  /// Weights of the newest average in the slow and fast running averages of likelihoods. 0: no
  /// random poses are added.
  double alpha_slow = 0.0;
  double alpha_fast = 0.0;
  /// Greatest error of the distribution, and the quantile of the probability of a lower one.
  double error = 0.05;
  double z = 0.99;
};

/// How many particles represent `bins` occupied bins, within the limits of the settings.
int particles_needed(const FilterSettings& settings, size_t bins);

/// Weighted mean and covariance. Yaw is averaged on the circle; its covariance has no share with
/// the position.
struct PoseEstimate {
  double weight = 0.0;
  pf_vector_t mean{};
  pf_matrix_t covariance{};
};

using Particles = std::vector<pf_sample_t>;

/// Multiplies the weights by the likelihood of a measurement. False: nothing was measured, and the
/// weights are unchanged.
using WeighParticles = std::function<bool(Particles& particles, bool is_converged)>;
using MakePose = std::function<pf_vector_t(Random& random)>;

class ParticleFilter {
 public:
  /// `random` belongs to the caller, so that a new filter does not repeat the numbers of the last.
  ParticleFilter(const FilterSettings& settings, Random& random);

  /// Spreads the most particles by a normal distribution. Of the covariance, the block of x and y
  /// and the variance of yaw count; a negative variance counts as 0.
  void reset(const pf_vector_t& mean, const pf_matrix_t& covariance);
  /// Spreads the most particles by a function.
  void reset(const MakePose& make_pose);
  /// `pose` is where odometry sees the robot now, `delta` how it changed since the last move.
  void move(MotionModel& model, const pf_vector_t& pose, const pf_vector_t& delta);
  void measure(const WeighParticles& weigh);
  /// Draws a new set. `make_pose` makes the random poses with which the filter recovers when the
  /// likelihood drops; it may be empty.
  void resample(const MakePose& make_pose);

  const Particles& particles() const { return particles_; }
  /// Since the last reset or resampling, as are the following.
  const std::vector<PoseEstimate>& clusters() const { return clusters_; }
  const PoseEstimate& whole() const { return whole_; }
  /// The cluster with the largest weight; null when the filter has no particles.
  const PoseEstimate* best_cluster() const;
  /// True when all particles are within 0.5 m of their mean in x and y.
  bool is_converged() const { return is_converged_; }

 private:
  double share_of_random_poses() const;
  void estimate();
  void check_convergence();

  FilterSettings settings_;
  Random& random_;
  Particles particles_;
  PoseBins bins_;
  std::vector<PoseEstimate> clusters_;
  PoseEstimate whole_;
  double slow_average_ = 0.0;
  double fast_average_ = 0.0;
  bool is_converged_ = false;
};

}  // namespace nav2_amcl
