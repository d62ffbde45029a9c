// See clear_costmap_service.hpp.
#include "nav2_costmap_2d/clear_costmap_service.hpp"

#include "nav2_costmap_2d/costmap_2d_ros.hpp"

namespace nav2_costmap_2d {

ClearCostmapService::ClearCostmapService(const nav2_util::LifecycleNode::WeakPtr& parent,
                                         Costmap2DROS& costmap)
    : logger_(rclcpp::get_logger("nav2_costmap_2d")), costmap_(costmap) {
  const auto node = parent.lock();
  logger_ = node->get_logger();
  const std::string name = costmap_.getName();
  clear_except_service_ = node->create_service<ExceptRegion>(
      "clear_except_" + name, [this, name](const ExceptRegion::Request::SharedPtr request,
                                           const ExceptRegion::Response::SharedPtr) {
        RCLCPP_INFO(logger_, "Received request to clear except a region the %s", name.c_str());
        clearRegion(request->reset_distance, true);
      });
  clear_around_service_ = node->create_service<AroundRobot>(
      "clear_around_" + name, [this](const AroundRobot::Request::SharedPtr request,
                                     const AroundRobot::Response::SharedPtr) {
        clearRegion(request->reset_distance, false);
      });
  clear_around_pose_service_ = node->create_service<AroundPose>(
      "clear_around_pose_" + name, [this, name](const AroundPose::Request::SharedPtr request,
                                                const AroundPose::Response::SharedPtr) {
        RCLCPP_INFO(logger_, "Received request to clear around pose for %s", name.c_str());
        clearAroundPose(request->pose, request->reset_distance);
      });
  clear_entire_service_ = node->create_service<Entirely>(
      "clear_entirely_" + name,
      [this, name](const Entirely::Request::SharedPtr, const Entirely::Response::SharedPtr) {
        RCLCPP_INFO(logger_, "Received request to clear entirely the %s", name.c_str());
        clearEntirely();
      });
}

ClearCostmapService::~ClearCostmapService() = default;

void ClearCostmapService::clearRegion(double reset_distance, bool invert) {
  geometry_msgs::msg::PoseStamped pose;
  if (!costmap_.getRobotPose(pose)) {
    RCLCPP_ERROR(logger_, "%s", "Cannot clear map because robot pose cannot be retrieved.");
    return;
  }
  clearSquare(pose.pose.position.x, pose.pose.position.y, reset_distance, invert);
}

void ClearCostmapService::clearAroundPose(const geometry_msgs::msg::PoseStamped& pose,
                                          double reset_distance) {
  geometry_msgs::msg::PoseStamped global;
  try {
    global = costmap_.getTfBuffer()->transform(
        pose, costmap_.getGlobalFrameID(), tf2::durationFromSec(costmap_.getTransformTolerance()));
  } catch (const tf2::TransformException& error) {
    RCLCPP_ERROR(logger_,
                 "Cannot clear map around pose because pose cannot be transformed to costmap "
                 "frame: %s",
                 error.what());
    return;
  }
  clearSquare(global.pose.position.x, global.pose.position.y, reset_distance, false);
}

void ClearCostmapService::clearSquare(double x, double y, double reset_distance, bool invert) {
  for (const auto& layer : *costmap_.getLayeredCostmap()->getPlugins()) {
    if (!layer->isClearable()) continue;
    if (const auto costs = std::dynamic_pointer_cast<CostmapLayer>(layer)) {
      clearLayerRegion(*costs, x, y, reset_distance, invert);
    }
  }
}

void ClearCostmapService::clearLayerRegion(CostmapLayer& layer, double x, double y,
                                           double reset_distance, bool invert) {
  const std::unique_lock<Costmap2D::mutex_t> lock(*layer.getMutex());
  const double half = reset_distance / 2;
  int start_x;
  int start_y;
  int end_x;
  int end_y;
  layer.worldToMapEnforceBounds(x - half, y - half, start_x, start_y);
  layer.worldToMapEnforceBounds(x + half, y + half, end_x, end_y);
  layer.clearArea(start_x, start_y, end_x, end_y, invert);
  const double left = layer.getOriginX();
  const double bottom = layer.getOriginY();
  layer.addExtraBounds(left, bottom, left + layer.getSizeInMetersX(),
                       bottom + layer.getSizeInMetersY());
}

void ClearCostmapService::clearEntirely() {
  const std::unique_lock<Costmap2D::mutex_t> lock(*costmap_.getCostmap()->getMutex());
  costmap_.resetLayers();
}

}  // namespace nav2_costmap_2d
