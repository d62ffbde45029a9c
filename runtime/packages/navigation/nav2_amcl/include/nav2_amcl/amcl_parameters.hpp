// The parameters of amcl, and what has to be made again when one changes.
#pragma once

#include <string>

#include "nav2_amcl/pf/particle_filter.hpp"
#include "nav2_amcl/sensors/laser_model.hpp"

namespace nav2_amcl {

struct AmclParameters {
  double alpha1 = 0.2;
  double alpha2 = 0.2;
  double alpha3 = 0.2;
  double alpha4 = 0.2;
  double alpha5 = 0.2;
  double laser_max_range = 100.0;    // m; that of the scan when it is not positive
  double laser_min_range = -1.0;     // m; that of the scan when it is not positive
  double initial_x = 0.0;            // m
  double initial_y = 0.0;            // m
  double initial_z = 0.0;            // m
  double initial_yaw = 0.0;          // rad
  double save_pose_rate = 0.5;       // Hz; as in upstream, nothing uses it
  double transform_tolerance = 1.0;  // s
  double update_min_a = 0.2;         // rad
  double update_min_d = 0.25;        // m
  int resample_interval = 1;         // updates
  std::string base_frame_id = "base_footprint";
  std::string global_frame_id = "map";
  std::string odom_frame_id = "odom";
  std::string laser_model_type = "likelihood_field";
  std::string robot_model_type = "nav2_amcl::DifferentialMotionModel";
  std::string scan_topic = "scan";
  std::string map_topic = "map";
  bool set_initial_pose = false;
  bool tf_broadcast = true;
  bool always_reset_initial_pose = false;
  bool first_map_only = false;
  bool freespace_downsampling = false;
  LaserSettings laser;
  FilterSettings filter;
};

/// Which part of the node depends on a parameter.
struct Renewal {
  bool filter = false;
  bool odometry = false;
  bool laser = false;
  bool map = false;
};

}  // namespace nav2_amcl
