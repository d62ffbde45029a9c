// See obstacle_layer.hpp.
#include "nav2_costmap_2d/obstacle_layer.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "pluginlib/class_list_macros.hpp"
#include "sensor_msgs/point_cloud2_iterator.hpp"

PLUGINLIB_EXPORT_CLASS(nav2_costmap_2d::ObstacleLayer, nav2_costmap_2d::Layer)

namespace nav2_costmap_2d {

using sensor_msgs::msg::LaserScan;
using sensor_msgs::msg::PointCloud2;
using Lock = std::unique_lock<Costmap2D::mutex_t>;
using BufferLock = std::lock_guard<ObservationBuffer>;

ObstacleLayer::~ObstacleLayer() {
  dyn_params_handler_.reset();
  observation_notifiers_.clear();
}

void ObstacleLayer::onInitialize() {
  readParameters();
  const auto node = node_.lock();
  rolling_window_ = layered_costmap_->isRolling();
  bool tracks_unknown = layered_costmap_->isTrackingUnknown();
  node->get_parameter("track_unknown_space", tracks_unknown);
  default_value_ = tracks_unknown ? NO_INFORMATION : FREE_SPACE;
  ObstacleLayer::matchSize();
  current_ = true;
  was_reset_ = false;
  global_frame_ = layered_costmap_->getGlobalFrameID();

  std::string topics;
  node->get_parameter(getFullName("observation_sources"), topics);
  RCLCPP_INFO(logger_, "Subscribed to Topics: %s", topics.c_str());
  constexpr char kSpace[] = " \t\r\n";
  for (size_t from = 0; (from = topics.find_first_not_of(kSpace, from)) != std::string::npos;) {
    const size_t end = std::min(topics.find_first_of(kSpace, from), topics.size());
    addSource(topics.substr(from, end - from));
    from = end;
  }
  dyn_params_handler_ =
      node->add_on_set_parameters_callback([this](std::vector<rclcpp::Parameter> parameters) {
        return dynamicParametersCallback(parameters);
      });
}

void ObstacleLayer::readParameters() {
  declareParameter("enabled", rclcpp::ParameterValue(true));
  declareParameter("footprint_clearing_enabled", rclcpp::ParameterValue(true));
  declareParameter("min_obstacle_height", rclcpp::ParameterValue(0.0));
  declareParameter("max_obstacle_height", rclcpp::ParameterValue(2.0));
  declareParameter("combination_method", rclcpp::ParameterValue(1));
  declareParameter("observation_sources", rclcpp::ParameterValue(std::string("")));
  const auto node = node_.lock();
  if (!node) throw std::runtime_error{"Failed to lock node"};
  node->get_parameter(getFullName("enabled"), enabled_);
  node->get_parameter(getFullName("footprint_clearing_enabled"), footprint_clearing_enabled_);
  node->get_parameter(getFullName("min_obstacle_height"), min_obstacle_height_);
  node->get_parameter(getFullName("max_obstacle_height"), max_obstacle_height_);
  int method = 1;
  node->get_parameter(getFullName("combination_method"), method);
  combination_method_ = combination_method_from_int(method);
}

void ObstacleLayer::addSource(const std::string& source) {
  const auto node = node_.lock();
  const auto value = [&](const std::string& name, auto fallback) {
    declareParameter(source + "." + name, rclcpp::ParameterValue(fallback));
    node->get_parameter(getFullName(source + "." + name), fallback);
    return fallback;
  };
  const std::string topic = value("topic", source);
  const std::string sensor_frame = value("sensor_frame", std::string());
  const double persistence = value("observation_persistence", 0.0);
  const double expected_rate = value("expected_update_rate", 0.0);
  const std::string data_type = value("data_type", std::string("LaserScan"));
  const double lowest = value("min_obstacle_height", 0.0);
  const double highest = value("max_obstacle_height", 0.0);
  const bool inf_is_valid = value("inf_is_valid", false);
  const bool marking = value("marking", true);
  const bool clearing = value("clearing", false);
  const double obstacle_max_range = value("obstacle_max_range", 2.5);
  const double obstacle_min_range = value("obstacle_min_range", 0.0);
  const double raytrace_max_range = value("raytrace_max_range", 3.0);
  const double raytrace_min_range = value("raytrace_min_range", 0.0);
  if (data_type != "PointCloud2" && data_type != "LaserScan") {
    const char* text = "Only topics that use point cloud2s or laser scans are currently supported";
    RCLCPP_FATAL(logger_, "%s", text);
    throw std::runtime_error(text);
  }
  double tolerance = 0.3;
  node->get_parameter("transform_tolerance", tolerance);

  auto buffer = std::make_shared<ObservationBuffer>(
      node_, topic, persistence, expected_rate, lowest, highest, obstacle_max_range,
      obstacle_min_range, raytrace_max_range, raytrace_min_range, *tf_, global_frame_, sensor_frame,
      tf2::durationFromSec(tolerance));
  observation_buffers_.push_back(buffer);
  if (marking) marking_buffers_.push_back(buffer);
  if (clearing) clearing_buffers_.push_back(buffer);
  if (data_type == "PointCloud2") {
    if (inf_is_valid) {
      RCLCPP_WARN(logger_,
                  "obstacle_layer: inf_is_valid option is not applicable to PointCloud "
                  "observations.");
    }
    subscribe<PointCloud2>(topic, sensor_frame, 50, [this, buffer](const auto& message) {
      pointCloud2Callback(message, buffer);
    });
  } else if (inf_is_valid) {
    subscribe<LaserScan>(topic, sensor_frame, 50, [this, buffer](const auto& message) {
      laserScanValidInfCallback(message, buffer);
    });
  } else {
    subscribe<LaserScan>(topic, sensor_frame, 50, [this, buffer](const auto& message) {
      laserScanCallback(message, buffer);
    });
  }
}

template <typename MessageT, typename CallbackT>
void ObstacleLayer::subscribe(const std::string& topic, const std::string& sensor_frame,
                              size_t queue, CallbackT callback) {
  const auto node = node_.lock();
  rmw_qos_profile_t qos = rmw_qos_profile_sensor_data;
  qos.depth = 50;
  rclcpp::SubscriptionOptions options;
  options.callback_group = callback_group_;
  auto subscriber =
      std::make_shared<message_filters::Subscriber<MessageT, rclcpp_lifecycle::LifecycleNode>>(
          node, topic, qos, options);
  subscriber->unsubscribe();
  double tolerance = 0.3;
  node->get_parameter("transform_tolerance", tolerance);
  auto filter = std::make_shared<tf2_ros::MessageFilter<MessageT>>(
      *subscriber, *tf_, global_frame_, queue, node->get_node_logging_interface(),
      node->get_node_clock_interface(), tf2::durationFromSec(tolerance));
  filter->registerCallback(callback);
  filter->setTolerance(rclcpp::Duration::from_seconds(0.05));
  if (!sensor_frame.empty()) {
    filter->setTargetFrames(std::vector<std::string>{global_frame_, sensor_frame});
  }
  observation_subscribers_.push_back(subscriber);
  observation_notifiers_.push_back(filter);
}

void ObstacleLayer::activate() {
  for (const auto& notifier : observation_notifiers_) notifier->clear();
  for (const auto& subscriber : observation_subscribers_) subscriber->subscribe();
  resetBuffersLastUpdated();
}

void ObstacleLayer::deactivate() {
  for (const auto& subscriber : observation_subscribers_) subscriber->unsubscribe();
}

void ObstacleLayer::reset() {
  resetMaps();
  resetBuffersLastUpdated();
  current_ = false;
  was_reset_ = true;
}

void ObstacleLayer::resetBuffersLastUpdated() {
  for (const auto& buffer : observation_buffers_) buffer->resetLastUpdated();
}

rcl_interfaces::msg::SetParametersResult ObstacleLayer::dynamicParametersCallback(
    std::vector<rclcpp::Parameter> parameters) {
  const Lock lock(*getMutex());
  rcl_interfaces::msg::SetParametersResult result;
  result.successful = true;
  for (const rclcpp::Parameter& parameter : parameters) {
    const std::string& name = parameter.get_name();
    const auto type = parameter.get_type();
    if (type == rclcpp::ParameterType::PARAMETER_DOUBLE) {
      if (name == getFullName("min_obstacle_height")) min_obstacle_height_ = parameter.as_double();
      if (name == getFullName("max_obstacle_height")) max_obstacle_height_ = parameter.as_double();
    } else if (type == rclcpp::ParameterType::PARAMETER_BOOL) {
      if (name == getFullName("enabled") && enabled_ != parameter.as_bool()) {
        enabled_ = parameter.as_bool();
        if (enabled_) current_ = false;
      }
      if (name == getFullName("footprint_clearing_enabled")) {
        footprint_clearing_enabled_ = parameter.as_bool();
      }
    } else if (type == rclcpp::ParameterType::PARAMETER_INTEGER) {
      if (name == getFullName("combination_method")) {
        combination_method_ = combination_method_from_int(static_cast<int>(parameter.as_int()));
      }
    }
  }
  return result;
}

void ObstacleLayer::bufferScan(const LaserScan& scan, ObservationBuffer& buffer) {
  PointCloud2 cloud;
  cloud.header = scan.header;
  try {
    projector_.transformLaserScanToPointCloud(scan.header.frame_id, scan, cloud, *tf_);
  } catch (const tf2::TransformException& error) {
    RCLCPP_WARN(logger_,
                "High fidelity enabled, but TF returned a transform exception to frame %s: %s",
                global_frame_.c_str(), error.what());
    projector_.projectLaser(scan, cloud);
  } catch (const std::runtime_error& error) {
    RCLCPP_WARN(logger_,
                "transformLaserScanToPointCloud error, it seems the message from laser is "
                "malformed. Ignore this message. what(): %s",
                error.what());
    return;
  }
  const BufferLock lock(buffer);
  buffer.bufferCloud(cloud);
}

void ObstacleLayer::laserScanCallback(LaserScan::ConstSharedPtr message,
                                      const std::shared_ptr<ObservationBuffer>& buffer) {
  bufferScan(*message, *buffer);
}

void ObstacleLayer::laserScanValidInfCallback(LaserScan::ConstSharedPtr raw_message,
                                              const std::shared_ptr<ObservationBuffer>& buffer) {
  constexpr float kEpsilon = 0.0001F;  // a range that is equal to the greatest is not valid
  LaserScan message = *raw_message;
  for (float& range : message.ranges) {
    if (!std::isfinite(range) && range > 0) range = message.range_max - kEpsilon;
  }
  bufferScan(message, *buffer);
}

void ObstacleLayer::pointCloud2Callback(PointCloud2::ConstSharedPtr message,
                                        const std::shared_ptr<ObservationBuffer>& buffer) {
  const BufferLock lock(*buffer);
  buffer->bufferCloud(*message);
}

void ObstacleLayer::addStaticObservation(Observation& obs, bool marking, bool clearing) {
  if (marking) static_marking_observations_.push_back(obs);
  if (clearing) static_clearing_observations_.push_back(obs);
}

void ObstacleLayer::clearStaticObservations(bool marking, bool clearing) {
  if (marking) static_marking_observations_.clear();
  if (clearing) static_clearing_observations_.clear();
}

namespace {

bool collect(const std::vector<std::shared_ptr<ObservationBuffer>>& buffers,
             const std::vector<Observation>& constant, std::vector<Observation>& observations) {
  bool is_current = true;
  for (const auto& buffer : buffers) {
    const BufferLock lock(*buffer);
    buffer->getObservations(observations);
    is_current = buffer->isCurrent() && is_current;
  }
  observations.insert(observations.end(), constant.begin(), constant.end());
  return is_current;
}

}  // namespace

bool ObstacleLayer::getMarkingObservations(std::vector<Observation>& marking_observations) const {
  return collect(marking_buffers_, static_marking_observations_, marking_observations);
}

bool ObstacleLayer::getClearingObservations(std::vector<Observation>& clearing_observations) const {
  return collect(clearing_buffers_, static_clearing_observations_, clearing_observations);
}

void ObstacleLayer::updateBounds(double robot_x, double robot_y, double robot_yaw, double* min_x,
                                 double* min_y, double* max_x, double* max_y) {
  const Lock lock(*getMutex());
  if (rolling_window_) {
    updateOrigin(robot_x - getSizeInMetersX() / 2, robot_y - getSizeInMetersY() / 2);
  }
  if (!enabled_) return;
  useExtraBounds(min_x, min_y, max_x, max_y);
  std::vector<Observation> marking;
  std::vector<Observation> clearing;
  const bool has_marks = getMarkingObservations(marking);
  const bool has_clears = getClearingObservations(clearing);
  current_ = has_marks && has_clears;
  for (const Observation& observation : clearing) {
    raytraceFreespace(observation, min_x, min_y, max_x, max_y);
  }
  for (const Observation& observation : marking) {
    markObservation(observation, min_x, min_y, max_x, max_y);
  }
  updateFootprint(robot_x, robot_y, robot_yaw, min_x, min_y, max_x, max_y);
}

void ObstacleLayer::markObservation(const Observation& observation, double* min_x, double* min_y,
                                    double* max_x, double* max_y) {
  const double farthest = observation.obstacle_max_range_ * observation.obstacle_max_range_;
  const double nearest = observation.obstacle_min_range_ * observation.obstacle_min_range_;
  const auto& origin = observation.origin_;
  unsigned int mx;
  unsigned int my;
  if (!worldToMap(origin.x, origin.y, mx, my)) return;
  const PointCloud2& cloud = *observation.cloud_;
  sensor_msgs::PointCloud2ConstIterator<float> x(cloud, "x");
  sensor_msgs::PointCloud2ConstIterator<float> y(cloud, "y");
  sensor_msgs::PointCloud2ConstIterator<float> z(cloud, "z");
  for (; x != x.end(); ++x, ++y, ++z) {
    const double px = *x;
    const double py = *y;
    const double pz = *z;
    if (pz < min_obstacle_height_ || pz > max_obstacle_height_) continue;
    const double dx = px - origin.x;
    const double dy = py - origin.y;
    const double square = dx * dx + dy * dy;
    if (square > farthest || square < nearest) continue;
    if (!worldToMap(px, py, mx, my)) continue;
    costmap_[getIndex(mx, my)] = LETHAL_OBSTACLE;
    touch(px, py, min_x, min_y, max_x, max_y);
  }
}

void ObstacleLayer::updateFootprint(double robot_x, double robot_y, double robot_yaw, double* min_x,
                                    double* min_y, double* max_x, double* max_y) {
  if (!footprint_clearing_enabled_) return;
  transformFootprint(robot_x, robot_y, robot_yaw, getFootprint(), transformed_footprint_);
  for (const auto& point : transformed_footprint_) {
    touch(point.x, point.y, min_x, min_y, max_x, max_y);
  }
}

void ObstacleLayer::updateCosts(Costmap2D& master_grid, int min_i, int min_j, int max_i,
                                int max_j) {
  const Lock lock(*getMutex());
  if (!enabled_) return;
  // A round has passed since a reset.
  if (!current_ && was_reset_) {
    was_reset_ = false;
    current_ = true;
  }
  if (footprint_clearing_enabled_) setConvexPolygonCost(transformed_footprint_, FREE_SPACE);
  switch (combination_method_) {
    case CombinationMethod::Overwrite:
      updateWithOverwrite(master_grid, min_i, min_j, max_i, max_j);
      break;
    case CombinationMethod::Max:
      updateWithMax(master_grid, min_i, min_j, max_i, max_j);
      break;
    case CombinationMethod::MaxWithoutUnknownOverwrite:
      updateWithMaxWithoutUnknownOverwrite(master_grid, min_i, min_j, max_i, max_j);
      break;
  }
}

void ObstacleLayer::raytraceFreespace(const Observation& clearing_observation, double* min_x,
                                      double* min_y, double* max_x, double* max_y) {
  const double ox = clearing_observation.origin_.x;
  const double oy = clearing_observation.origin_.y;
  unsigned int x0;
  unsigned int y0;
  if (!worldToMap(ox, oy, x0, y0)) {
    RCLCPP_WARN(logger_,
                "Sensor origin at (%.2f, %.2f) is out of map bounds (%.2f, %.2f) to (%.2f, %.2f). "
                "The costmap cannot raytrace for it.",
                ox, oy, origin_x_, origin_y_, origin_x_ + getSizeInMetersX(),
                origin_y_ + getSizeInMetersY());
    return;
  }
  touch(ox, oy, min_x, min_y, max_x, max_y);
  const double map_end_x = origin_x_ + size_x_ * resolution_;
  const double map_end_y = origin_y_ + size_y_ * resolution_;
  const unsigned int longest = cellDistance(clearing_observation.raytrace_max_range_);
  const unsigned int shortest = cellDistance(clearing_observation.raytrace_min_range_);
  MarkCell clear(costmap_, FREE_SPACE);
  sensor_msgs::PointCloud2ConstIterator<float> x(*clearing_observation.cloud_, "x");
  sensor_msgs::PointCloud2ConstIterator<float> y(*clearing_observation.cloud_, "y");
  for (; x != x.end(); ++x, ++y) {
    // Where the ray leaves the map.
    const double dx = *x - ox;
    const double dy = *y - oy;
    double share = 1.0;
    if (*x < origin_x_) share = std::min(share, (origin_x_ - ox) / dx);
    if (*y < origin_y_) share = std::min(share, (origin_y_ - oy) / dy);
    if (*x > map_end_x) share = std::min(share, (map_end_x - 0.001 - ox) / dx);
    if (*y > map_end_y) share = std::min(share, (map_end_y - 0.001 - oy) / dy);
    // Rounding must not put it outside.
    const double wx = std::max(ox + share * dx, origin_x_);
    const double wy = std::max(oy + share * dy, origin_y_);
    unsigned int x1;
    unsigned int y1;
    if (!worldToMap(wx, wy, x1, y1)) continue;
    raytraceLine(clear, x0, y0, x1, y1, longest, shortest);
    updateRaytraceBounds(ox, oy, wx, wy, clearing_observation.raytrace_max_range_,
                         clearing_observation.raytrace_min_range_, min_x, min_y, max_x, max_y);
  }
}

void ObstacleLayer::updateRaytraceBounds(double ox, double oy, double wx, double wy,
                                         double max_range, double min_range, double* min_x,
                                         double* min_y, double* max_x, double* max_y) {
  const double dx = wx - ox;
  const double dy = wy - oy;
  const double length = std::hypot(dx, dy);
  if (length < min_range) return;
  const double share = length > 0.0 ? std::min(1.0, max_range / length) : 1.0;
  touch(ox + dx * share, oy + dy * share, min_x, min_y, max_x, max_y);
}

}  // namespace nav2_costmap_2d
