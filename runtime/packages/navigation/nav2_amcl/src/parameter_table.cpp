// See parameter_table.hpp.
#include "parameter_table.hpp"

namespace nav2_amcl {
namespace {

template <typename T>
using Rows = std::vector<ParameterRow<T>>;

template <typename T>
std::function<T&(AmclParameters&)> own(T AmclParameters::*member) {
  return [member](AmclParameters& all) -> T& { return all.*member; };
}
template <typename T>
std::function<T&(AmclParameters&)> laser(T LaserSettings::*member) {
  return [member](AmclParameters& all) -> T& { return all.laser.*member; };
}
template <typename T>
std::function<T&(AmclParameters&)> filter(T FilterSettings::*member) {
  return [member](AmclParameters& all) -> T& { return all.filter.*member; };
}

using A = AmclParameters;
using L = LaserSettings;
using F = FilterSettings;

constexpr bool kNow = true;
constexpr bool kLater = false;

}  // namespace

const Rows<double>& double_parameters() {
  static const Rows<double> rows{
      {"alpha1", own(&A::alpha1), &Renewal::odometry, kNow, "Noise of rotation by rotation"},
      {"alpha2", own(&A::alpha2), &Renewal::odometry, kNow, "Noise of rotation by translation"},
      {"alpha3", own(&A::alpha3), &Renewal::odometry, kNow, "Noise of translation by translation"},
      {"alpha4", own(&A::alpha4), &Renewal::odometry, kNow, "Noise of translation by rotation"},
      {"alpha5", own(&A::alpha5), &Renewal::odometry, kNow,
       "Noise of sideways motion by translation (OmniMotionModel)"},
      {"beam_skip_distance", laser(&L::beam_skip_distance), &Renewal::laser, kNow,
       "A particle agrees with a beam that ends so near to something occupied [m]"},
      {"beam_skip_error_threshold", laser(&L::beam_skip_error_threshold), &Renewal::laser, kNow,
       "From this share of skipped beams on, all beams count"},
      {"beam_skip_threshold", laser(&L::beam_skip_threshold), &Renewal::laser, kNow,
       "A beam counts when more than this share of the particles agrees with it"},
      {"lambda_short", laser(&L::lambda_short), &Renewal::laser, kNow,
       "Decay of the part z_short of the beam model [1/m]"},
      {"laser_likelihood_max_dist", laser(&L::likelihood_max_dist), &Renewal::laser, kNow,
       "Greatest distance to something occupied in the likelihood field [m]"},
      {"laser_max_range", own(&A::laser_max_range), &Renewal::laser, kNow,
       "Longest range that counts [m]; that of the scan when it is not positive"},
      {"laser_min_range", own(&A::laser_min_range), &Renewal::laser, kNow,
       "Shortest range that counts [m]; that of the scan when it is not positive"},
      {"initial_pose.x", own(&A::initial_x), nullptr, kLater, "Where the robot is at first [m]"},
      {"initial_pose.y", own(&A::initial_y), nullptr, kLater, "Where the robot is at first [m]"},
      {"initial_pose.z", own(&A::initial_z), nullptr, kLater, "Where the robot is at first [m]"},
      {"initial_pose.yaw", own(&A::initial_yaw), nullptr, kLater,
       "Where the robot looks at first [rad]"},
      {"pf_err", filter(&F::error), &Renewal::filter, kNow,
       "Greatest error of the distribution of particles"},
      {"pf_z", filter(&F::z), &Renewal::filter, kNow,
       "Quantile of the probability that the error is lower than pf_err"},
      {"recovery_alpha_fast", filter(&F::alpha_fast), &Renewal::filter, kNow,
       "Rate of the fast average of weights; with the slow one, 0.1 and 0.001 are usual"},
      {"recovery_alpha_slow", filter(&F::alpha_slow), &Renewal::filter, kNow,
       "Rate of the slow average of weights; 0: no random poses are added"},
      {"save_pose_rate", own(&A::save_pose_rate), nullptr, kNow, "Accepted, and without effect"},
      {"sigma_hit", laser(&L::sigma_hit), &Renewal::laser, kNow,
       "Standard deviation of ranges in the part z_hit [m]"},
      {"transform_tolerance", own(&A::transform_tolerance), &Renewal::laser, kNow,
       "How far into the future the published transform is valid [s]"},
      {"update_min_a", own(&A::update_min_a), nullptr, kNow,
       "Rotation after which the filter is updated [rad]"},
      {"update_min_d", own(&A::update_min_d), nullptr, kNow,
       "Translation after which the filter is updated [m]"},
      {"z_hit", laser(&L::z_hit), &Renewal::laser, kNow, "Weight of ranges that fit the map"},
      {"z_max", laser(&L::z_max), &Renewal::laser, kNow, "Weight of ranges that are the longest"},
      {"z_rand", laser(&L::z_rand), &Renewal::laser, kNow, "Weight of random ranges"},
      {"z_short", laser(&L::z_short), &Renewal::laser, kNow,
       "Weight of ranges that are shorter than the map says"},
  };
  return rows;
}

const Rows<int>& integer_parameters() {
  static const Rows<int> rows{
      {"max_beams", laser(&L::max_beams), &Renewal::laser, kNow,
       "How many beams of a scan are used; below 2, scans have no effect"},
      {"max_particles", filter(&F::max_particles), &Renewal::filter, kNow,
       "Greatest number of particles"},
      {"min_particles", filter(&F::min_particles), &Renewal::filter, kNow,
       "Least number of particles"},
      {"resample_interval", own(&A::resample_interval), nullptr, kNow,
       "Updates between two resamplings"},
  };
  return rows;
}

const Rows<bool>& bool_parameters() {
  static const Rows<bool> rows{
      {"do_beamskip", laser(&L::do_beamskip), &Renewal::laser, kNow,
       "Whether likelihood_field_prob skips beams that most particles disagree with"},
      {"set_initial_pose", own(&A::set_initial_pose), nullptr, kNow,
       "Whether the node starts at initial_pose"},
      {"tf_broadcast", own(&A::tf_broadcast), nullptr, kNow,
       "Whether the transform from the map to odometry is published"},
      {"always_reset_initial_pose", own(&A::always_reset_initial_pose), nullptr, kLater,
       "Whether the last pose is forgotten when the node is configured again"},
      {"first_map_only", own(&A::first_map_only), nullptr, kNow,
       "Whether maps after the first one are ignored"},
      {"freespace_downsampling", own(&A::freespace_downsampling), nullptr, kLater,
       "Whether random poses are drawn from every second row and column only"},
  };
  return rows;
}

const Rows<std::string>& string_parameters() {
  static const Rows<std::string> rows{
      {"base_frame_id", own(&A::base_frame_id), nullptr, kNow, "Frame of the robot"},
      {"global_frame_id", own(&A::global_frame_id), nullptr, kNow, "Frame of the map"},
      {"odom_frame_id", own(&A::odom_frame_id), &Renewal::laser, kNow, "Frame of odometry"},
      {"laser_model_type", own(&A::laser_model_type), &Renewal::laser, kNow,
       "beam, likelihood_field or likelihood_field_prob"},
      {"robot_model_type", own(&A::robot_model_type), &Renewal::odometry, kNow,
       "Plugin of the motion model"},
      {"scan_topic", own(&A::scan_topic), &Renewal::laser, kNow, "Topic of scans"},
      {"map_topic", own(&A::map_topic), &Renewal::map, kNow, "Topic of the map"},
  };
  return rows;
}

}  // namespace nav2_amcl
