// The parameters of ekf_node and ukf_node: which topics are fused, and how.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "filter/filter.hpp"
#include "rclcpp/rclcpp.hpp"

namespace robot_localization {

constexpr double kNoThreshold = std::numeric_limits<double>::max();

/// One input: `odom0` and the parameters that begin so.
struct InputParameters {
  std::string name;
  std::string topic;
  Variables config;  ///< only what such a message has
  bool is_differential = false;
  bool is_relative = false;
  bool is_pose_of_child = false;
  bool removes_gravity = false;
  double pose_threshold = kNoThreshold;  ///< [standard deviations], as the next two
  double twist_threshold = kNoThreshold;
  double acceleration_threshold = kNoThreshold;
  int queue_size = 10;
};

struct FilterParameters {
  double frequency = 30.0;             ///< [Hz]
  double sensor_timeout = 0.0;         ///< [s]
  double transform_time_offset = 0.0;  ///< [s]
  double transform_timeout = 0.0;      ///< [s]
  double history_length = 0.0;         ///< [s]
  double gravity = 9.80665;            ///< [m/s^2]
  bool is_two_d = false;
  bool prints_diagnostics = false;
  bool publishes_tf = true;
  bool publishes_acceleration = false;
  bool permits_corrected_publication = false;
  bool predicts_to_current_time = false;
  bool smooths_lagged_data = false;
  bool resets_on_time_jump = false;
  bool is_disabled_at_startup = false;
  bool is_noise_dynamic = false;
  std::string map_frame, odom_frame, base_link_frame, base_link_frame_output, world_frame;
  std::optional<ControlModel> control;
  bool is_control_stamped = false;
  std::optional<State> initial_state;
  std::optional<Covariance> process_noise;
  std::optional<Covariance> initial_covariance;
  std::vector<InputParameters> odoms, poses, twists, imus;
};

/// Declares and reads them all, and logs what is odd about them. Throws std::invalid_argument for
/// values with which no filter can run.
FilterParameters read_parameters(rclcpp::Node& node);

}  // namespace robot_localization
