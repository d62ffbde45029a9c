// See amcl_node.hpp. The map, and poses that others give: one pose, or the whole map.
#include <cmath>
#include <cstdlib>
#include <utility>

#include "nav2_amcl/amcl_node.hpp"
#include "nav2_util/string_utils.hpp"
#include "nav2_util/validate_messages.hpp"
#include "tf2/utils.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

namespace nav2_amcl {
namespace {

CellState state_of(std::int8_t occupancy) {
  if (occupancy == 0) return CellState::Free;
  return occupancy == 100 ? CellState::Occupied : CellState::Unknown;
}

std::shared_ptr<OccupancyMap> map_from(const nav_msgs::msg::OccupancyGrid& message) {
  MapGeometry geometry;
  geometry.width = static_cast<int>(message.info.width);
  geometry.height = static_cast<int>(message.info.height);
  geometry.resolution = message.info.resolution;
  geometry.origin_x = message.info.origin.position.x;
  geometry.origin_y = message.info.origin.position.y;
  std::vector<CellState> cells;
  cells.reserve(message.data.size());
  for (const std::int8_t occupancy : message.data) cells.push_back(state_of(occupancy));
  return std::make_shared<OccupancyMap>(geometry, std::move(cells));
}

}  // namespace

void AmclNode::mapReceived(const nav_msgs::msg::OccupancyGrid::SharedPtr msg) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  RCLCPP_DEBUG(get_logger(), "AmclNode: A new map was received.");
  if (!nav2_util::validateMsg(*msg)) {
    RCLCPP_ERROR(get_logger(), "Received map message is malformed. Rejecting.");
    return;
  }
  if (parameters_.first_map_only && map_ != nullptr) return;
  RCLCPP_INFO(get_logger(), "Received a %d X %d map @ %.3f m/pix",
              static_cast<int>(msg->info.width), static_cast<int>(msg->info.height),
              msg->info.resolution);
  if (msg->header.frame_id != parameters_.global_frame_id) {
    RCLCPP_WARN(get_logger(),
                "Frame_id of map received:'%s' doesn't match global_frame_id:'%s'. This could"
                " cause issues with reading published topics",
                msg->header.frame_id.c_str(), parameters_.global_frame_id.c_str());
  }
  // Models of scanners measure in the old map.
  scanners_.clear();
  map_ = map_from(*msg);
  free_cells_ = map_->free_cells(parameters_.freespace_downsampling ? 2 : 1);
}

void AmclNode::initialPoseReceived(PoseWithCovariance::SharedPtr msg) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  RCLCPP_INFO(get_logger(), "initialPoseReceived");
  if (!nav2_util::validateMsg(*msg)) {
    RCLCPP_ERROR(get_logger(), "Received initialpose message is malformed. Rejecting.");
    return;
  }
  const std::string frame = nav2_util::strip_leading_slash(msg->header.frame_id);
  if (frame != parameters_.global_frame_id) {
    RCLCPP_WARN(get_logger(),
                "Ignoring initial pose in frame \"%s\"; initial poses must be in the global frame, "
                "\"%s\"",
                frame.c_str(), parameters_.global_frame_id.c_str());
    return;
  }
  // As in upstream, metres are compared with cells: a pose near a map is inside.
  const auto& position = msg->pose.pose.position;
  if (map_ != nullptr && (std::abs(position.x) > map_->geometry().width ||
                          std::abs(position.y) > map_->geometry().height)) {
    RCLCPP_ERROR(get_logger(),
                 "Received initialpose from message is out of the size of map. Rejecting.");
    return;
  }
  last_published_pose_ = *msg;
  if (!active_) {
    init_pose_received_on_inactive_ = true;
    RCLCPP_WARN(get_logger(),
                "Received initial pose request, but AMCL is not yet in the active state");
    return;
  }
  handleInitialPose(*msg);
}

void AmclNode::handleInitialPose(const PoseWithCovariance& msg) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  // The robot may have driven on since the time of the pose.
  tf2::Transform driven = tf2::Transform::getIdentity();
  try {
    tf2::fromMsg(
        tf_buffer_
            ->lookupTransform(parameters_.base_frame_id, tf2_ros::fromMsg(msg.header.stamp),
                              parameters_.base_frame_id, tf2_ros::fromRclcpp(now()),
                              parameters_.odom_frame_id)
            .transform,
        driven);
  } catch (const tf2::TransformException& error) {
    // Before the first odometry the robot counts as not moved. That is normal at the start.
    if (sent_first_transform_) {
      RCLCPP_WARN(get_logger(), "Failed to transform initial pose in time (%s)", error.what());
    }
  }
  tf2::Transform given;
  tf2::fromMsg(msg.pose.pose, given);
  const tf2::Transform pose = given * driven;
  const pf_vector_t mean{
      {pose.getOrigin().x(), pose.getOrigin().y(), tf2::getYaw(pose.getRotation())}};
  RCLCPP_INFO(get_logger(), "Setting pose (%.6f): %.3f %.3f %.3f", now().seconds(), mean.v[0],
              mean.v[1], mean.v[2]);
  pf_matrix_t covariance{};
  for (size_t i = 0; i < 2; ++i) {
    for (size_t j = 0; j < 2; ++j) covariance.m[i][j] = msg.pose.covariance[6 * i + j];
  }
  covariance.m[2][2] = msg.pose.covariance[35];
  filter_->reset(mean, covariance);
  has_odom_pose_ = false;
  init_pose_received_on_inactive_ = false;
  initial_pose_is_known_ = true;
}

void AmclNode::globalLocalization() {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  RCLCPP_INFO(get_logger(), "Initializing with uniform distribution");
  if (free_cells_.empty()) {
    RCLCPP_WARN(get_logger(), "No map with free cells was received, so no poses can be drawn");
    return;
  }
  filter_->reset(randomPoses());
  RCLCPP_INFO(get_logger(), "Global initialisation done!");
  initial_pose_is_known_ = true;
  has_odom_pose_ = false;
}

MakePose AmclNode::randomPoses() const {
  if (free_cells_.empty()) return nullptr;
  return [this](Random& random) { return randomFreePose(random); };
}

pf_vector_t AmclNode::randomFreePose(Random& random) const {
  const auto count = static_cast<double>(free_cells_.size());
  const OccupancyMap::Point point =
      map_->point_of(free_cells_[static_cast<size_t>(random.uniform() * count)]);
  return {{point.x, point.y, random.uniform() * 2 * M_PI - M_PI}};
}

}  // namespace nav2_amcl
