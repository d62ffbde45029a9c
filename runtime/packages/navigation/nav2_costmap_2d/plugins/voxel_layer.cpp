// See voxel_layer.hpp.
#include "nav2_costmap_2d/voxel_layer.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "pluginlib/class_list_macros.hpp"
#include "sensor_msgs/point_cloud2_iterator.hpp"

PLUGINLIB_EXPORT_CLASS(nav2_costmap_2d::VoxelLayer, nav2_costmap_2d::Layer)

namespace nav2_costmap_2d {

using Lock = std::unique_lock<Costmap2D::mutex_t>;

/// Voxels of a column.
constexpr int kVoxelBits = 16;

VoxelLayer::~VoxelLayer() {
  voxel_params_handler_.reset();
}

void VoxelLayer::onInitialize() {
  ObstacleLayer::onInitialize();
  readParameters();
  const auto node = node_.lock();
  if (publish_voxel_) {
    voxel_pub_ = node->create_publisher<nav2_msgs::msg::VoxelGrid>(
        "voxel_grid", rclcpp::QoS(rclcpp::KeepLast(1)).transient_local().reliable());
    voxel_pub_->on_activate();
  }
  matchSize();
  voxel_params_handler_ =
      node->add_on_set_parameters_callback([this](std::vector<rclcpp::Parameter> parameters) {
        return dynamicParametersCallback(parameters);
      });
}

void VoxelLayer::readParameters() {
  declareParameter("z_voxels", rclcpp::ParameterValue(10));
  declareParameter("origin_z", rclcpp::ParameterValue(0.0));
  declareParameter("z_resolution", rclcpp::ParameterValue(0.2));
  declareParameter("unknown_threshold", rclcpp::ParameterValue(15));
  declareParameter("mark_threshold", rclcpp::ParameterValue(0));
  declareParameter("publish_voxel_map", rclcpp::ParameterValue(false));
  const auto node = node_.lock();
  if (!node) throw std::runtime_error{"Failed to lock node"};
  node->get_parameter(getFullName("publish_voxel_map"), publish_voxel_);
  node->get_parameter(getFullName("origin_z"), origin_z_);
  node->get_parameter(getFullName("z_resolution"), z_resolution_);
  node->get_parameter(getFullName("mark_threshold"), mark_threshold_);
  node->get_parameter(getFullName("z_voxels"), size_z_);
  size_z_ = std::clamp(size_z_, 0, kVoxelBits);
  node->get_parameter(getFullName("unknown_threshold"), unknown_threshold_);
  // The bits above the highest voxel are always unknown.
  unknown_threshold_ += kVoxelBits - size_z_;
}

void VoxelLayer::matchSize() {
  const Lock lock(*getMutex());
  ObstacleLayer::matchSize();
  voxel_grid_.resize(size_x_, size_y_, static_cast<unsigned int>(size_z_));
}

void VoxelLayer::reset() {
  ObstacleLayer::reset();
}

void VoxelLayer::resetMaps() {
  ObstacleLayer::resetMaps();
  voxel_grid_.reset();
}

void VoxelLayer::updateOrigin(double new_origin_x, double new_origin_y) {
  const int dx = static_cast<int>((new_origin_x - origin_x_) / resolution_);
  const int dy = static_cast<int>((new_origin_y - origin_y_) / resolution_);
  const int width = static_cast<int>(size_x_);
  const int height = static_cast<int>(size_y_);
  const std::vector<uint32_t> before(
      voxel_grid_.getData(), voxel_grid_.getData() + static_cast<size_t>(size_x_) * size_y_);
  Costmap2D::updateOrigin(new_origin_x, new_origin_y);
  voxel_grid_.reset();
  for (int y = std::max(0, -dy); y < std::min(height, height - dy); ++y) {
    for (int x = std::max(0, -dx); x < std::min(width, width - dx); ++x) {
      voxel_grid_.getData()[y * width + x] =
          before[static_cast<size_t>(y + dy) * size_x_ + static_cast<size_t>(x + dx)];
    }
  }
}

void VoxelLayer::updateBounds(double robot_x, double robot_y, double robot_yaw, double* min_x,
                              double* min_y, double* max_x, double* max_y) {
  const Lock lock(*getMutex());
  ObstacleLayer::updateBounds(robot_x, robot_y, robot_yaw, min_x, min_y, max_x, max_y);
  if (enabled_ && publish_voxel_) publishVoxels();
}

void VoxelLayer::markObservation(const Observation& observation, double* min_x, double* min_y,
                                 double* max_x, double* max_y) {
  const double farthest = observation.obstacle_max_range_ * observation.obstacle_max_range_;
  const double nearest = observation.obstacle_min_range_ * observation.obstacle_min_range_;
  sensor_msgs::PointCloud2ConstIterator<float> x(*observation.cloud_, "x");
  sensor_msgs::PointCloud2ConstIterator<float> y(*observation.cloud_, "y");
  sensor_msgs::PointCloud2ConstIterator<float> z(*observation.cloud_, "z");
  for (; x != x.end(); ++x, ++y, ++z) {
    if (*z > max_obstacle_height_) continue;
    const double dx = *x - observation.origin_.x;
    const double dy = *y - observation.origin_.y;
    const double dz = *z - observation.origin_.z;
    const double square = dx * dx + dy * dy + dz * dz;
    if (square >= farthest || square < nearest) continue;
    unsigned int mx;
    unsigned int my;
    unsigned int mz;
    // Points below the grid, such as those of the ground, are in its lowest voxels.
    const double height = *z < origin_z_ ? origin_z_ : *z;
    if (!worldToMap3D(*x, *y, height, mx, my, mz)) continue;
    if (*z < min_obstacle_height_) continue;
    if (!voxel_grid_.markVoxelInMap(mx, my, mz, static_cast<unsigned int>(mark_threshold_))) {
      continue;
    }
    costmap_[getIndex(mx, my)] = LETHAL_OBSTACLE;
    touch(*x, *y, min_x, min_y, max_x, max_y);
  }
}

void VoxelLayer::raytraceFreespace(const Observation& clearing_observation, double* min_x,
                                   double* min_y, double* max_x, double* max_y) {
  const auto& origin = clearing_observation.origin_;
  double sx;
  double sy;
  double sz;
  if (!worldToMap3DFloat(origin.x, origin.y, origin.z, sx, sy, sz)) {
    RCLCPP_WARN(logger_,
                "Sensor origin at (%.2f, %.2f %.2f) is out of map bounds (%.2f, %.2f, %.2f) to "
                "(%.2f, %.2f, %.2f). The costmap cannot raytrace for it.",
                origin.x, origin.y, origin.z, origin_x_, origin_y_, origin_z_,
                origin_x_ + getSizeInMetersX(), origin_y_ + getSizeInMetersY(),
                origin_z_ + getSizeInMetersZ());
    return;
  }
  const double end_x = origin_x_ + getSizeInMetersX();
  const double end_y = origin_y_ + getSizeInMetersY();
  const double end_z = origin_z_ + size_z_ * z_resolution_;
  const unsigned int longest = cellDistance(clearing_observation.raytrace_max_range_);
  const unsigned int shortest = cellDistance(clearing_observation.raytrace_min_range_);
  sensor_msgs::PointCloud2ConstIterator<float> x(*clearing_observation.cloud_, "x");
  sensor_msgs::PointCloud2ConstIterator<float> y(*clearing_observation.cloud_, "y");
  sensor_msgs::PointCloud2ConstIterator<float> z(*clearing_observation.cloud_, "z");
  for (; x != x.end(); ++x, ++y, ++z) {
    const double dx = *x - origin.x;
    const double dy = *y - origin.y;
    const double dz = *z - origin.z;
    // The ray ends before the point, which it would open at a flat angle, and where it leaves the
    // grid.
    const double length = std::sqrt(dx * dx + dy * dy + dz * dz);
    double share = length > 0.0 ? std::max(1.0 - 2 * resolution_ / length, 0.0) : 0.0;
    if (*x < origin_x_) share = std::min(share, (origin_x_ - origin.x) / dx);
    if (*y < origin_y_) share = std::min(share, (origin_y_ - origin.y) / dy);
    if (*z < origin_z_) share = std::min(share, (origin_z_ - origin.z) / dz);
    if (*x > end_x) share = std::min(share, (end_x - origin.x) / dx);
    if (*y > end_y) share = std::min(share, (end_y - origin.y) / dy);
    if (*z > end_z) share = std::min(share, (end_z - origin.z) / dz);
    const double wx = std::max(origin.x + share * dx, origin_x_);
    const double wy = std::max(origin.y + share * dy, origin_y_);
    const double wz = std::clamp(origin.z + share * dz, origin_z_, end_z - z_resolution_ * 1e-6);
    double px;
    double py;
    double pz;
    if (!worldToMap3DFloat(wx, wy, wz, px, py, pz)) continue;
    voxel_grid_.clearVoxelLineInMap(
        sx, sy, sz, px, py, pz, costmap_, static_cast<unsigned int>(unknown_threshold_),
        static_cast<unsigned int>(mark_threshold_), FREE_SPACE, NO_INFORMATION, longest, shortest);
    updateRaytraceBounds(origin.x, origin.y, wx, wy, clearing_observation.raytrace_max_range_,
                         clearing_observation.raytrace_min_range_, min_x, min_y, max_x, max_y);
  }
}

void VoxelLayer::publishVoxels() {
  auto message = std::make_unique<nav2_msgs::msg::VoxelGrid>();
  message->size_x = voxel_grid_.sizeX();
  message->size_y = voxel_grid_.sizeY();
  message->size_z = voxel_grid_.sizeZ();
  const size_t columns = static_cast<size_t>(message->size_x) * message->size_y;
  message->data.assign(voxel_grid_.getData(), voxel_grid_.getData() + columns);
  message->origin.x = static_cast<float>(origin_x_);
  message->origin.y = static_cast<float>(origin_y_);
  message->origin.z = static_cast<float>(origin_z_);
  message->resolutions.x = static_cast<float>(resolution_);
  message->resolutions.y = static_cast<float>(resolution_);
  message->resolutions.z = static_cast<float>(z_resolution_);
  message->header.frame_id = global_frame_;
  message->header.stamp = clock_->now();
  voxel_pub_->publish(std::move(message));
}

rcl_interfaces::msg::SetParametersResult VoxelLayer::dynamicParametersCallback(
    std::vector<rclcpp::Parameter> parameters) {
  const Lock lock(*getMutex());
  rcl_interfaces::msg::SetParametersResult result;
  result.successful = true;
  bool is_resized = false;
  for (const rclcpp::Parameter& parameter : parameters) {
    const std::string& name = parameter.get_name();
    if (parameter.get_type() == rclcpp::ParameterType::PARAMETER_DOUBLE) {
      if (name == getFullName("origin_z")) origin_z_ = parameter.as_double();
      if (name == getFullName("z_resolution")) z_resolution_ = parameter.as_double();
      is_resized |= name == getFullName("origin_z") || name == getFullName("z_resolution");
    } else if (parameter.get_type() == rclcpp::ParameterType::PARAMETER_INTEGER) {
      const int value = static_cast<int>(parameter.as_int());
      if (name == getFullName("mark_threshold")) mark_threshold_ = value;
      if (name == getFullName("unknown_threshold")) {
        unknown_threshold_ = value + kVoxelBits - size_z_;
      }
      if (name == getFullName("z_voxels")) {
        size_z_ = std::clamp(value, 0, kVoxelBits);
        is_resized = true;
      }
    } else if (name == getFullName("publish_voxel_map")) {
      RCLCPP_WARN(logger_,
                  "publish voxel map is not a dynamic parameter cannot be changed while "
                  "running. Rejecting parameter update.");
    }
  }
  if (is_resized) matchSize();
  return result;
}

}  // namespace nav2_costmap_2d
