// The parameters of the nodes.
#pragma once

#include <string>
#include <vector>

#include "core/mapper.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace slam_toolbox {

struct Parameters {
  std::string odom_frame = "odom";
  std::string map_frame = "map";
  std::string base_frame = "base_footprint";
  std::string map_name = "/map";
  std::string scan_topic = "/scan";
  std::string map_file_name;
  std::vector<double> map_start_pose;  ///< x, y, yaw; empty when it is not set
  bool map_start_at_dock = false;
  bool use_map_saver = true;
  bool use_lifecycle_manager = false;
  bool debug_logging = false;
  int scan_queue_size = 1;
  int throttle_scans = 1;
  double resolution = 0.05;                ///< [m]
  double max_laser_range = 25.0;           ///< [m], 0 or less: that of the laser
  double map_update_interval = 10.0;       ///< [s], as the next
  double transform_publish_period = 0.05;  ///< 0: the transform is not published
  double transform_timeout = 0.5;
  double tf_buffer_duration = 30.0;
  double minimum_time_interval = 0.5;
  double position_covariance_scale = 1.0;
  double yaw_covariance_scale = 1.0;
  MapperSettings mapper;
};

/// Declares what is not declared yet, and reads it. A value that cannot be used is replaced by the
/// default, or the nearest that can, with a warning.
Parameters read_parameters(rclcpp_lifecycle::LifecycleNode& node);

}  // namespace slam_toolbox
