// See static_layer.hpp.
#include "nav2_costmap_2d/static_layer.hpp"

#include <algorithm>
#include <stdexcept>

#include "nav2_util/validate_messages.hpp"
#include "pluginlib/class_list_macros.hpp"
#include "tf2/convert.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

PLUGINLIB_EXPORT_CLASS(nav2_costmap_2d::StaticLayer, nav2_costmap_2d::Layer)

namespace nav2_costmap_2d {

using nav_msgs::msg::OccupancyGrid;
using rcl_interfaces::msg::ParameterType;
using Lock = std::unique_lock<Costmap2D::mutex_t>;

StaticLayer::StaticLayer() = default;
StaticLayer::~StaticLayer() = default;

void StaticLayer::onInitialize() {
  global_frame_ = layered_costmap_->getGlobalFrameID();
  getParameters();
  rclcpp::QoS qos(10);
  if (map_subscribe_transient_local_) qos = rclcpp::QoS(1).transient_local().reliable();
  RCLCPP_INFO(logger_, "Subscribing to the map topic (%s) with %s durability", map_topic_.c_str(),
              map_subscribe_transient_local_ ? "transient local" : "volatile");
  const auto node = node_.lock();
  map_sub_ = node->create_subscription<OccupancyGrid>(
      map_topic_, qos, [this](const OccupancyGrid::SharedPtr map) { incomingMap(map); });
  if (!subscribe_to_updates_) return;
  RCLCPP_INFO(logger_, "Subscribing to updates");
  map_update_sub_ = node->create_subscription<map_msgs::msg::OccupancyGridUpdate>(
      map_topic_ + "_updates", rclcpp::SystemDefaultsQoS(),
      [this](map_msgs::msg::OccupancyGridUpdate::ConstSharedPtr update) {
        incomingUpdate(update);
      });
}

void StaticLayer::activate() {}

void StaticLayer::deactivate() {
  const auto node = node_.lock();
  if (dyn_params_handler_ && node) {
    node->remove_on_set_parameters_callback(dyn_params_handler_.get());
  }
  dyn_params_handler_.reset();
}

void StaticLayer::reset() {
  has_updated_data_ = true;
  current_ = false;
}

void StaticLayer::getParameters() {
  declareParameter("enabled", rclcpp::ParameterValue(true));
  declareParameter("subscribe_to_updates", rclcpp::ParameterValue(false));
  declareParameter("map_subscribe_transient_local", rclcpp::ParameterValue(true));
  declareParameter("transform_tolerance", rclcpp::ParameterValue(0.0));
  declareParameter("map_topic", rclcpp::ParameterValue(""));
  declareParameter("footprint_clearing_enabled", rclcpp::ParameterValue(false));
  const auto node = node_.lock();
  if (!node) throw std::runtime_error{"Failed to lock node"};
  node->get_parameter(getFullName("enabled"), enabled_);
  node->get_parameter(getFullName("subscribe_to_updates"), subscribe_to_updates_);
  node->get_parameter(getFullName("footprint_clearing_enabled"), footprint_clearing_enabled_);
  node->get_parameter(getFullName("map_subscribe_transient_local"), map_subscribe_transient_local_);
  node->get_parameter(getFullName("map_topic"), map_topic_);
  if (map_topic_.empty()) node->get_parameter("map_topic", map_topic_);
  node->get_parameter("track_unknown_space", track_unknown_space_);
  node->get_parameter("use_maximum", use_maximum_);
  node->get_parameter("trinary_costmap", trinary_costmap_);
  int threshold = 100;
  node->get_parameter("lethal_cost_threshold", threshold);
  lethal_threshold_ = static_cast<unsigned char>(std::clamp(threshold, 0, 100));
  int unknown = 255;
  node->get_parameter("unknown_cost_value", unknown);
  unknown_cost_value_ = static_cast<unsigned char>(std::clamp(unknown, 0, 255));
  double tolerance = 0.0;
  node->get_parameter("transform_tolerance", tolerance);
  transform_tolerance_ = tf2::durationFromSec(tolerance);
  dyn_params_handler_ =
      node->add_on_set_parameters_callback([this](std::vector<rclcpp::Parameter> parameters) {
        return dynamicParametersCallback(parameters);
      });
}

void StaticLayer::processMap(const OccupancyGrid& new_map) {
  const unsigned int size_x = new_map.info.width;
  const unsigned int size_y = new_map.info.height;
  const double resolution = new_map.info.resolution;
  const double origin_x = new_map.info.origin.position.x;
  const double origin_y = new_map.info.origin.position.y;
  const auto has_place = [&](const Costmap2D& map) {
    return map.getSizeInCellsX() == size_x && map.getSizeInCellsY() == size_y &&
           map.getResolution() == resolution && map.getOriginX() == origin_x &&
           map.getOriginY() == origin_y;
  };
  if (!layered_costmap_->isRolling() &&
      (!has_place(*layered_costmap_->getCostmap()) || !layered_costmap_->isSizeLocked())) {
    RCLCPP_INFO(logger_, "StaticLayer: Resizing costmap to %d X %d at %f m/pix", size_x, size_y,
                resolution);
    layered_costmap_->resizeMap(size_x, size_y, resolution, origin_x, origin_y, true);
  } else if (!has_place(*this)) {
    RCLCPP_INFO(logger_, "StaticLayer: Resizing static layer to %d X %d at %f m/pix", size_x,
                size_y, resolution);
    resizeMap(size_x, size_y, resolution, origin_x, origin_y);
  }
  const Lock lock(*getMutex());
  std::transform(new_map.data.begin(), new_map.data.end(), costmap_, [this](int8_t value) {
    return interpretValue(static_cast<unsigned char>(value));
  });
  map_frame_ = new_map.header.frame_id;
  x_ = y_ = 0;
  width_ = size_x_;
  height_ = size_y_;
  has_updated_data_ = true;
  current_ = true;
}

void StaticLayer::matchSize() {
  // A map of its own size stays as it is.
  if (layered_costmap_->isRolling()) return;
  CostmapLayer::matchSize();
}

unsigned char StaticLayer::interpretValue(unsigned char value) {
  if (value == unknown_cost_value_) return track_unknown_space_ ? NO_INFORMATION : FREE_SPACE;
  if (value >= lethal_threshold_) return LETHAL_OBSTACLE;
  if (trinary_costmap_) return FREE_SPACE;
  const double share = static_cast<double>(value) / lethal_threshold_;
  return static_cast<unsigned char>(share * LETHAL_OBSTACLE);
}

void StaticLayer::incomingMap(const OccupancyGrid::SharedPtr new_map) {
  if (!nav2_util::validateMsg(*new_map)) {
    RCLCPP_ERROR(logger_, "Received map message is malformed. Rejecting.");
    return;
  }
  // The first is taken at once, as it gives the costmap its size; others between two rounds. Rounds
  // lock the costmap before its layers, so the layer is not locked while the costmap gets its size.
  if (!map_received_) {
    const Lock whole(*layered_costmap_->getCostmap()->getMutex());
    processMap(*new_map);
    map_received_ = true;
    return;
  }
  const Lock lock(*getMutex());
  map_buffer_ = new_map;
}

void StaticLayer::incomingUpdate(map_msgs::msg::OccupancyGridUpdate::ConstSharedPtr update) {
  const Lock lock(*getMutex());
  const auto right = static_cast<int64_t>(update->x) + update->width;
  const auto top = static_cast<int64_t>(update->y) + update->height;
  if (update->x < static_cast<int32_t>(x_) || update->y < static_cast<int32_t>(y_) ||
      right > x_ + width_ || top > y_ + height_ ||
      update->data.size() < static_cast<size_t>(update->width) * update->height) {
    RCLCPP_WARN(logger_,
                "StaticLayer: Map update ignored. Exceeds bounds of static layer.\n"
                "Static layer origin: %d, %d   bounds: %d X %d\n"
                "Update origin: %d, %d   bounds: %d X %d",
                x_, y_, width_, height_, update->x, update->y, update->width, update->height);
    return;
  }
  if (update->header.frame_id != map_frame_) {
    RCLCPP_WARN(logger_,
                "StaticLayer: Map update ignored. Current map is in frame %s but update was in "
                "frame %s",
                map_frame_.c_str(), update->header.frame_id.c_str());
    return;
  }
  size_t at = 0;
  for (unsigned int y = 0; y < update->height; ++y) {
    unsigned char* row = costmap_ + getIndex(static_cast<unsigned int>(update->x),
                                             static_cast<unsigned int>(update->y) + y);
    for (unsigned int x = 0; x < update->width; ++x) {
      row[x] = interpretValue(static_cast<unsigned char>(update->data[at++]));
    }
  }
  has_updated_data_ = true;
}

void StaticLayer::updateBounds(double robot_x, double robot_y, double robot_yaw, double* min_x,
                               double* min_y, double* max_x, double* max_y) {
  map_received_in_update_bounds_ = map_received_;
  if (!map_received_) return;
  const Lock lock(*getMutex());
  if (map_buffer_) {
    processMap(*map_buffer_);
    map_buffer_ = nullptr;
  }
  if (!layered_costmap_->isRolling() && !(has_updated_data_ || has_extra_bounds_)) return;
  useExtraBounds(min_x, min_y, max_x, max_y);
  if (layered_costmap_->isRolling()) {
    // All of the costmap: the map is in another frame.
    const Costmap2D* costmap = layered_costmap_->getCostmap();
    const double half_x = costmap->getSizeInMetersX() / 2;
    const double half_y = costmap->getSizeInMetersY() / 2;
    touch(robot_x - half_x, robot_y - half_y, min_x, min_y, max_x, max_y);
    touch(robot_x + half_x, robot_y + half_y, min_x, min_y, max_x, max_y);
  } else {
    double wx;
    double wy;
    mapToWorld(x_, y_, wx, wy);
    touch(wx, wy, min_x, min_y, max_x, max_y);
    mapToWorld(x_ + width_, y_ + height_, wx, wy);
    touch(wx, wy, min_x, min_y, max_x, max_y);
  }
  has_updated_data_ = false;
  updateFootprint(robot_x, robot_y, robot_yaw, min_x, min_y, max_x, max_y);
}

void StaticLayer::updateFootprint(double robot_x, double robot_y, double robot_yaw, double* min_x,
                                  double* min_y, double* max_x, double* max_y) {
  if (!footprint_clearing_enabled_) return;
  transformFootprint(robot_x, robot_y, robot_yaw, getFootprint(), transformed_footprint_);
  for (const auto& point : transformed_footprint_) {
    touch(point.x, point.y, min_x, min_y, max_x, max_y);
  }
}

void StaticLayer::updateCosts(Costmap2D& master_grid, int min_i, int min_j, int max_i, int max_j) {
  const Lock lock(*getMutex());
  if (!enabled_) return;
  if (!map_received_in_update_bounds_) {
    static int count = 0;
    // With the usual five rounds a second, every two seconds.
    if (++count == 10) {
      RCLCPP_WARN(logger_, "Can't update static costmap layer, no map received");
      count = 0;
    }
    return;
  }
  if (footprint_clearing_enabled_) setConvexPolygonCost(transformed_footprint_, FREE_SPACE);
  if (layered_costmap_->isRolling()) {
    updateRolling(master_grid, min_i, min_j, max_i, max_j);
  } else if (use_maximum_) {
    updateWithMax(master_grid, min_i, min_j, max_i, max_j);
  } else {
    updateWithTrueOverwrite(master_grid, min_i, min_j, max_i, max_j);
  }
  current_ = true;
}

void StaticLayer::updateRolling(Costmap2D& master_grid, int min_i, int min_j, int max_i,
                                int max_j) {
  tf2::Transform to_map;
  try {
    const auto transform =
        tf_->lookupTransform(map_frame_, global_frame_, tf2::TimePointZero, transform_tolerance_);
    tf2::fromMsg(transform.transform, to_map);
  } catch (const tf2::TransformException& error) {
    RCLCPP_ERROR(logger_, "StaticLayer: %s", error.what());
    return;
  }
  for (int j = min_j; j < max_j; ++j) {
    for (int i = min_i; i < max_i; ++i) {
      const auto x = static_cast<unsigned int>(i);
      const auto y = static_cast<unsigned int>(j);
      double wx;
      double wy;
      master_grid.mapToWorld(x, y, wx, wy);
      const tf2::Vector3 place = to_map * tf2::Vector3(wx, wy, 0);
      unsigned int mx;
      unsigned int my;
      if (!worldToMap(place.x(), place.y(), mx, my)) continue;
      const unsigned char own = getCost(mx, my);
      master_grid.setCost(x, y, use_maximum_ ? std::max(own, master_grid.getCost(x, y)) : own);
    }
  }
}

rcl_interfaces::msg::SetParametersResult StaticLayer::dynamicParametersCallback(
    std::vector<rclcpp::Parameter> parameters) {
  const Lock lock(*getMutex());
  rcl_interfaces::msg::SetParametersResult result;
  result.successful = true;
  for (const rclcpp::Parameter& parameter : parameters) {
    const std::string& name = parameter.get_name();
    if (name == getFullName("map_subscribe_transient_local") || name == getFullName("map_topic") ||
        name == getFullName("subscribe_to_updates")) {
      RCLCPP_WARN(logger_,
                  "%s is not a dynamic parameter cannot be changed while running. Rejecting "
                  "parameter update.",
                  name.c_str());
    } else if (name == getFullName("transform_tolerance") &&
               parameter.get_type() == rclcpp::ParameterType::PARAMETER_DOUBLE) {
      transform_tolerance_ = tf2::durationFromSec(parameter.as_double());
    } else if (name == getFullName("enabled") &&
               parameter.get_type() == rclcpp::ParameterType::PARAMETER_BOOL) {
      if (enabled_ == parameter.as_bool()) continue;
      enabled_ = parameter.as_bool();
      x_ = y_ = 0;
      width_ = size_x_;
      height_ = size_y_;
      has_updated_data_ = true;
      current_ = false;
    } else if (name == getFullName("footprint_clearing_enabled") &&
               parameter.get_type() == rclcpp::ParameterType::PARAMETER_BOOL) {
      footprint_clearing_enabled_ = parameter.as_bool();
    }
  }
  return result;
}

}  // namespace nav2_costmap_2d
