// A cloud that a sensor saw, in the global frame, and how far it counts [m].
#pragma once

#include <memory>

#include "geometry_msgs/msg/point.hpp"
#include "sensor_msgs/msg/point_cloud2.hpp"

namespace nav2_costmap_2d {

/// Copies share the cloud, which nobody changes once it is there.
class Observation {
 public:
  Observation()
      : cloud_(std::make_shared<sensor_msgs::msg::PointCloud2>()),
        obstacle_max_range_(0.0),
        obstacle_min_range_(0.0),
        raytrace_max_range_(0.0),
        raytrace_min_range_(0.0) {}
  virtual ~Observation() = default;
  Observation(const Observation& obs) = default;
  Observation& operator=(const Observation& obs) = default;
  /// `origin`: of the sensor. Points between the ranges are obstacles; cells between the ray-trace
  /// ranges on the way to a point are free.
  Observation(geometry_msgs::msg::Point& origin, const sensor_msgs::msg::PointCloud2& cloud,
              double obstacle_max_range, double obstacle_min_range, double raytrace_max_range,
              double raytrace_min_range)
      : origin_(origin),
        cloud_(std::make_shared<sensor_msgs::msg::PointCloud2>(cloud)),
        obstacle_max_range_(obstacle_max_range),
        obstacle_min_range_(obstacle_min_range),
        raytrace_max_range_(raytrace_max_range),
        raytrace_min_range_(raytrace_min_range) {}
  Observation(const sensor_msgs::msg::PointCloud2& cloud, double obstacle_max_range,
              double obstacle_min_range)
      : cloud_(std::make_shared<sensor_msgs::msg::PointCloud2>(cloud)),
        obstacle_max_range_(obstacle_max_range),
        obstacle_min_range_(obstacle_min_range),
        raytrace_max_range_(0.0),
        raytrace_min_range_(0.0) {}

  geometry_msgs::msg::Point origin_;
  std::shared_ptr<sensor_msgs::msg::PointCloud2> cloud_;
  double obstacle_max_range_;
  double obstacle_min_range_;
  double raytrace_max_range_;
  double raytrace_min_range_;
};

}  // namespace nav2_costmap_2d
