// Obstacles in three dimensions: a column of voxels over each cell, which is an obstacle while
// enough of them are marked.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "nav2_costmap_2d/obstacle_layer.hpp"
#include "nav2_msgs/msg/voxel_grid.hpp"
#include "nav2_voxel_grid/voxel_grid.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/point_cloud2.hpp"

namespace nav2_costmap_2d {

class VoxelLayer : public ObstacleLayer {
 public:
  VoxelLayer() : voxel_grid_(0, 0, 0) {}
  virtual ~VoxelLayer();

  virtual void onInitialize();
  virtual void updateBounds(double robot_x, double robot_y, double robot_yaw, double* min_x,
                            double* min_y, double* max_x, double* max_y);
  void updateOrigin(double new_origin_x, double new_origin_y);
  bool isDiscretized() { return true; }
  virtual void matchSize();
  virtual void reset();
  virtual bool isClearable() { return true; }

 protected:
  virtual void resetMaps();
  virtual void raytraceFreespace(const Observation& clearing_observation, double* min_x,
                                 double* min_y, double* max_x, double* max_y);
  void markObservation(const Observation& observation, double* min_x, double* min_y, double* max_x,
                       double* max_y) override;
  rcl_interfaces::msg::SetParametersResult dynamicParametersCallback(
      std::vector<rclcpp::Parameter> parameters);

  /// In voxels, with fractions; false outside of the grid.
  inline bool worldToMap3DFloat(double wx, double wy, double wz, double& mx, double& my,
                                double& mz) {
    mx = (wx - origin_x_) / resolution_;
    my = (wy - origin_y_) / resolution_;
    mz = (wz - origin_z_) / z_resolution_;
    return mx >= 0 && my >= 0 && mz >= 0 && mx < size_x_ && my < size_y_ && mz < size_z_;
  }
  inline bool worldToMap3D(double wx, double wy, double wz, unsigned int& mx, unsigned int& my,
                           unsigned int& mz) {
    double x;
    double y;
    double z;
    if (!worldToMap3DFloat(wx, wy, wz, x, y, z)) return false;
    mx = static_cast<unsigned int>(x);
    my = static_cast<unsigned int>(y);
    mz = static_cast<unsigned int>(z);
    return true;
  }
  inline void mapToWorld3D(unsigned int mx, unsigned int my, unsigned int mz, double& wx,
                           double& wy, double& wz) {
    mapToWorld(mx, my, wx, wy);
    wz = origin_z_ + (mz + 0.5) * z_resolution_;
  }
  double getSizeInMetersZ() const { return (size_z_ - 1 + 0.5) * z_resolution_; }

  bool publish_voxel_ = false;
  rclcpp_lifecycle::LifecyclePublisher<nav2_msgs::msg::VoxelGrid>::SharedPtr voxel_pub_;
  nav2_voxel_grid::VoxelGrid voxel_grid_;
  double z_resolution_ = 0.2;
  double origin_z_ = 0.0;
  int unknown_threshold_ = 15;
  int mark_threshold_ = 0;
  int size_z_ = 10;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr voxel_params_handler_;

 private:
  void readParameters();
  void publishVoxels();
};

}  // namespace nav2_costmap_2d
