// Obstacles that lidars and depth cameras see: points are marked, the way to them is cleared.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "laser_geometry/laser_geometry.hpp"
#include "message_filters/subscriber.h"
#include "nav2_costmap_2d/costmap_layer.hpp"
#include "nav2_costmap_2d/footprint.hpp"
#include "nav2_costmap_2d/layered_costmap.hpp"
#include "nav2_costmap_2d/observation_buffer.hpp"
#include "nav_msgs/msg/occupancy_grid.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "sensor_msgs/msg/point_cloud2.hpp"
#include "tf2_ros/message_filter.h"

namespace nav2_costmap_2d {

class ObstacleLayer : public CostmapLayer {
 public:
  ObstacleLayer() = default;
  virtual ~ObstacleLayer();

  virtual void onInitialize();
  virtual void updateBounds(double robot_x, double robot_y, double robot_yaw, double* min_x,
                            double* min_y, double* max_x, double* max_y);
  virtual void updateCosts(Costmap2D& master_grid, int min_i, int min_j, int max_i, int max_j);
  virtual void deactivate();
  virtual void activate();
  virtual void reset();
  virtual bool isClearable() { return true; }
  rcl_interfaces::msg::SetParametersResult dynamicParametersCallback(
      std::vector<rclcpp::Parameter> parameters);
  void resetBuffersLastUpdated();

  void laserScanCallback(sensor_msgs::msg::LaserScan::ConstSharedPtr message,
                         const std::shared_ptr<ObservationBuffer>& buffer);
  /// Infinite ranges count as the greatest range, so that the way there is cleared.
  void laserScanValidInfCallback(sensor_msgs::msg::LaserScan::ConstSharedPtr message,
                                 const std::shared_ptr<ObservationBuffer>& buffer);
  void pointCloud2Callback(sensor_msgs::msg::PointCloud2::ConstSharedPtr message,
                           const std::shared_ptr<ObservationBuffer>& buffer);

  // For tests of layers.
  void addStaticObservation(Observation& obs, bool marking, bool clearing);
  void clearStaticObservations(bool marking, bool clearing);

 protected:
  /// Whether all are as new as expected.
  bool getMarkingObservations(std::vector<Observation>& marking_observations) const;
  bool getClearingObservations(std::vector<Observation>& clearing_observations) const;
  virtual void raytraceFreespace(const Observation& clearing_observation, double* min_x,
                                 double* min_y, double* max_x, double* max_y);
  /// Marks the cells of the points that are in range, and widens bounds by them.
  virtual void markObservation(const Observation& observation, double* min_x, double* min_y,
                               double* max_x, double* max_y);
  /// Widens bounds by the part of a ray that is between two ranges.
  void updateRaytraceBounds(double ox, double oy, double wx, double wy, double max_range,
                            double min_range, double* min_x, double* min_y, double* max_x,
                            double* max_y);
  void updateFootprint(double robot_x, double robot_y, double robot_yaw, double* min_x,
                       double* min_y, double* max_x, double* max_y);

  std::vector<geometry_msgs::msg::Point> transformed_footprint_;
  bool footprint_clearing_enabled_ = true;
  std::string global_frame_;
  double min_obstacle_height_ = 0.0;
  double max_obstacle_height_ = 2.0;
  laser_geometry::LaserProjection projector_;
  std::vector<std::shared_ptr<message_filters::SubscriberBase<rclcpp_lifecycle::LifecycleNode>>>
      observation_subscribers_;
  std::vector<std::shared_ptr<tf2_ros::MessageFilterBase>> observation_notifiers_;
  std::vector<std::shared_ptr<ObservationBuffer>> observation_buffers_;
  std::vector<std::shared_ptr<ObservationBuffer>> marking_buffers_;
  std::vector<std::shared_ptr<ObservationBuffer>> clearing_buffers_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr dyn_params_handler_;
  std::vector<Observation> static_clearing_observations_;
  std::vector<Observation> static_marking_observations_;
  bool rolling_window_ = false;
  bool was_reset_ = false;
  CombinationMethod combination_method_ = CombinationMethod::Max;

 private:
  void readParameters();
  void addSource(const std::string& source);
  template <typename MessageT, typename CallbackT>
  void subscribe(const std::string& topic, const std::string& sensor_frame, size_t queue,
                 CallbackT callback);
  void bufferScan(const sensor_msgs::msg::LaserScan& scan, ObservationBuffer& buffer);
};

}  // namespace nav2_costmap_2d
