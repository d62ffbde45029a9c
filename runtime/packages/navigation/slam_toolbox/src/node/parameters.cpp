// See parameters.hpp.
#include "node/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slam_toolbox {
namespace {

using rclcpp_lifecycle::LifecycleNode;

class Reading {
 public:
  explicit Reading(LifecycleNode& node) : node_(node) {}

  template <typename T>
  void read(const char* name, T& value) {
    if (!node_.has_parameter(name)) node_.declare_parameter(name, value);
    node_.get_parameter(name, value);
  }
  /// Numbers with limits, both allowed.
  template <typename T>
  void read(const char* name, T& value, double least, double most) {
    const T usual = value;
    read(name, value);
    const auto number = static_cast<double>(value);
    if (number >= least && number <= most) return;
    // The limits may depend on other parameters, so the default may be outside, too.
    value = static_cast<T>(std::clamp(static_cast<double>(usual), least, most));
    RCLCPP_WARN(
        node_.get_logger(),
        "You've set %s to %g, this isn't allowed so it will be set to %g. It has to be from "
        "%g to %g.",
        name, number, static_cast<double>(value), least, most);
  }

 private:
  LifecycleNode& node_;
};

constexpr double kLongest = 1e6;     // [m] or [s]
constexpr double kLeastCell = 1e-3;  // [m]
// Limits of one search, so that it fits into memory.
constexpr double kMostSteps = 200.0;
constexpr double kMostTurns = 100.0;       // to each side
constexpr double kExpansion = M_PI / 3.0;  // [rad], by which the angles may grow

void read_space(Reading& reading, const std::string& name, SearchSpace& space) {
  reading.read((name + "_dimension").c_str(), space.dimension, kLeastCell, 100.0);
  reading.read((name + "_resolution").c_str(), space.resolution,
               std::max(kLeastCell, space.dimension / kMostSteps), 1.0);
  reading.read((name + "_smear_deviation").c_str(), space.smear_deviation, 0.5 * space.resolution,
               10.0 * space.resolution);
}

void read_matcher(Reading& reading, MatcherSettings& matcher) {
  reading.read("distance_variance_penalty", matcher.distance_variance_penalty, 1e-6, kLongest);
  reading.read("angle_variance_penalty", matcher.angle_variance_penalty, 1e-6, kLongest);
  reading.read("fine_search_angle_offset", matcher.fine_search_angle_offset, 1e-4, 1.0);
  reading.read("coarse_search_angle_offset", matcher.coarse_search_angle_offset, 0.0, M_PI);
  reading.read("coarse_angle_resolution", matcher.coarse_angle_resolution,
               (matcher.coarse_search_angle_offset + kExpansion) / kMostTurns, 1.0);
  reading.read("minimum_angle_penalty", matcher.minimum_angle_penalty, 0.0, kLongest);
  reading.read("minimum_distance_penalty", matcher.minimum_distance_penalty, 0.0, kLongest);
  reading.read("use_response_expansion", matcher.use_response_expansion);
}

void read_mapper(Reading& reading, MapperSettings& mapper) {
  reading.read("use_scan_matching", mapper.use_scan_matching);
  reading.read("use_scan_barycenter", mapper.use_scan_barycenter);
  reading.read("minimum_travel_distance", mapper.minimum_travel_distance, 0.0, kLongest);
  reading.read("minimum_travel_heading", mapper.minimum_travel_heading, 0.0, kLongest);
  reading.read("scan_buffer_size", mapper.scan_buffer_size, 1, 10'000);
  reading.read("scan_buffer_maximum_scan_distance", mapper.scan_buffer_maximum_scan_distance,
               kLeastCell, kLongest);
  reading.read("link_match_minimum_response_fine", mapper.link_match_minimum_response_fine, 0.0,
               1.0);
  reading.read("link_scan_maximum_distance", mapper.link_scan_maximum_distance, 0.0, kLongest);
  reading.read("loop_search_maximum_distance", mapper.loop_search_maximum_distance, 0.0, kLongest);
  reading.read("do_loop_closing", mapper.do_loop_closing);
  reading.read("loop_match_minimum_chain_size", mapper.loop_match_minimum_chain_size, 0, 1'000'000);
  reading.read("loop_match_maximum_variance_coarse", mapper.loop_match_maximum_variance_coarse, 0.0,
               kLongest);
  reading.read("loop_match_minimum_response_coarse", mapper.loop_match_minimum_response_coarse, 0.0,
               1.0);
  reading.read("loop_match_minimum_response_fine", mapper.loop_match_minimum_response_fine, 0.0,
               1.0);
  read_space(reading, "correlation_search_space", mapper.correlation);
  read_space(reading, "loop_search_space", mapper.loop);
  read_matcher(reading, mapper.matcher);
}

/// Parameters of the solver and of other modes: a file may set them, and others may ask for them.
void declare_others(Reading& reading) {
  std::string solver = "solver_plugins::CeresSolver";
  reading.read("solver_plugin", solver);
  for (const auto& [name, value] :
       {std::pair("ceres_linear_solver", "SPARSE_NORMAL_CHOLESKY"),
        std::pair("ceres_preconditioner", "JACOBI"),
        std::pair("ceres_trust_strategy", "LEVENBERG_MARQUARDT"),
        std::pair("ceres_dogleg_type", "TRADITIONAL_DOGLEG"),
        std::pair("ceres_loss_function", "None"), std::pair("mode", "mapping")}) {
    std::string text = value;
    reading.read(name, text);
  }
  int stack_size = 40'000'000;
  reading.read("stack_size_to_use", stack_size);
  bool is_off = false;
  reading.read("enable_interactive_mode", is_off);
  bool is_paused = false;
  reading.read("paused_new_measurements", is_paused);
}

}  // namespace

Parameters read_parameters(LifecycleNode& node) {
  Parameters result;
  Reading reading(node);
  reading.read("odom_frame", result.odom_frame);
  reading.read("map_frame", result.map_frame);
  reading.read("base_frame", result.base_frame);
  reading.read("map_name", result.map_name);
  reading.read("scan_topic", result.scan_topic);
  reading.read("map_file_name", result.map_file_name);
  reading.read("map_start_pose", result.map_start_pose);
  reading.read("map_start_at_dock", result.map_start_at_dock);
  reading.read("use_map_saver", result.use_map_saver);
  reading.read("use_lifecycle_manager", result.use_lifecycle_manager);
  reading.read("debug_logging", result.debug_logging);
  reading.read("scan_queue_size", result.scan_queue_size, 1, 100'000);
  reading.read("throttle_scans", result.throttle_scans, 1, 1'000'000);
  reading.read("resolution", result.resolution, kLeastCell, 10.0);
  reading.read("max_laser_range", result.max_laser_range, -kLongest, kLongest);
  reading.read("map_update_interval", result.map_update_interval, 0.01, kLongest);
  reading.read("transform_publish_period", result.transform_publish_period, 0.0, kLongest);
  // A shorter one would leave no time for anything else.
  double& period = result.transform_publish_period;
  if (period > 0.0) period = std::max(period, 0.001);
  reading.read("transform_timeout", result.transform_timeout, 0.0, kLongest);
  reading.read("tf_buffer_duration", result.tf_buffer_duration, 0.0, kLongest);
  reading.read("minimum_time_interval", result.minimum_time_interval, 0.0, kLongest);
  reading.read("position_covariance_scale", result.position_covariance_scale, 0.0, kLongest);
  reading.read("yaw_covariance_scale", result.yaw_covariance_scale, 0.0, kLongest);
  read_mapper(reading, result.mapper);
  declare_others(reading);
  return result;
}

}  // namespace slam_toolbox
