// The clouds of one sensor in the global frame, for as long as they count.
#pragma once

#include <list>
#include <mutex>
#include <string>
#include <vector>

#include "nav2_costmap_2d/observation.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "rclcpp/time.hpp"
#include "sensor_msgs/msg/point_cloud2.hpp"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "tf2_ros/buffer.h"
#include "tf2_sensor_msgs/tf2_sensor_msgs.hpp"

namespace nav2_costmap_2d {

class ObservationBuffer {
 public:
  /// `observation_keep_time` [s]; 0: only the newest cloud counts. `expected_update_rate` [s]
  /// between two clouds; 0: any. Heights and ranges in metres. `sensor_frame` empty: that of the
  /// cloud.
  ObservationBuffer(const nav2_util::LifecycleNode::WeakPtr& parent, std::string topic_name,
                    double observation_keep_time, double expected_update_rate,
                    double min_obstacle_height, double max_obstacle_height,
                    double obstacle_max_range, double obstacle_min_range, double raytrace_max_range,
                    double raytrace_min_range, tf2_ros::Buffer& tf2_buffer,
                    std::string global_frame, std::string sensor_frame, tf2::Duration tf_tolerance);
  ~ObservationBuffer();

  /// Points outside of the heights are dropped. Nothing, with an error logged, when a transform is
  /// missing.
  void bufferCloud(const sensor_msgs::msg::PointCloud2& cloud);
  /// Appends those that still count.
  void getObservations(std::vector<Observation>& observations);
  /// Whether the last cloud is as new as expected.
  bool isCurrent() const;
  inline void lock() { lock_.lock(); }
  inline void unlock() { lock_.unlock(); }
  void resetLastUpdated();

 private:
  void purgeStaleObservations();

  rclcpp::Clock::SharedPtr clock_;
  rclcpp::Logger logger_{rclcpp::get_logger("nav2_costmap_2d")};
  tf2_ros::Buffer& tf2_buffer_;
  const rclcpp::Duration observation_keep_time_;
  const rclcpp::Duration expected_update_rate_;
  rclcpp::Time last_updated_;
  std::string global_frame_;
  std::string sensor_frame_;
  std::list<Observation> observation_list_;  // the newest first
  std::string topic_name_;
  double min_obstacle_height_;
  double max_obstacle_height_;
  std::recursive_mutex lock_;
  double obstacle_max_range_;
  double obstacle_min_range_;
  double raytrace_max_range_;
  double raytrace_min_range_;
  tf2::Duration tf_tolerance_;
};

}  // namespace nav2_costmap_2d
