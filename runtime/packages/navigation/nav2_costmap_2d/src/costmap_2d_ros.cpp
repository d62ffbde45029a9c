// See costmap_2d_ros.hpp. Parameters are in costmap_2d_parameters.cpp.
#include "nav2_costmap_2d/costmap_2d_ros.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "nav2_costmap_2d/costmap_layer.hpp"
#include "nav2_util/node_utils.hpp"
#include "nav2_util/robot_utils.hpp"
#include "tf2_ros/create_timer_ros.h"

namespace nav2_costmap_2d {

using nav2_util::CallbackReturn;
using std::chrono::milliseconds;

namespace {

rclcpp::NodeOptions child_options(const std::string& name, const std::string& parent_namespace,
                                  const std::string& local_namespace, bool use_sim_time) {
  const std::string parent = parent_namespace == "/" ? "" : parent_namespace;
  const std::string separator = local_namespace.rfind('/', 0) == 0 ? "" : "/";
  return rclcpp::NodeOptions().arguments(
      {"--ros-args", "-r", "__ns:=" + parent + separator + local_namespace, "--ros-args", "-r",
       name + ":__node:=" + name, "--ros-args", "-p",
       std::string("use_sim_time:=") + (use_sim_time ? "true" : "false")});
}

}  // namespace

Costmap2DROS::Costmap2DROS(const rclcpp::NodeOptions& options)
    : nav2_util::LifecycleNode("costmap", "", options), name_("costmap"), parent_namespace_("/") {
  is_lifecycle_follower_ = false;
  declare_parameter("map_topic", rclcpp::ParameterValue(std::string("map")));
  init();
}

Costmap2DROS::Costmap2DROS(const std::string& name, const bool& use_sim_time)
    : Costmap2DROS(name, "/", name, use_sim_time) {}

Costmap2DROS::Costmap2DROS(const std::string& name, const std::string& parent_namespace,
                           const std::string& local_namespace, const bool& use_sim_time)
    : nav2_util::LifecycleNode(
          name, "", child_options(name, parent_namespace, local_namespace, use_sim_time)),
      name_(name),
      parent_namespace_(parent_namespace) {
  const std::string parent = parent_namespace_ == "/" ? "/" : parent_namespace_ + "/";
  declare_parameter("map_topic", rclcpp::ParameterValue(parent + "map"));
  init();
}

Costmap2DROS::~Costmap2DROS() = default;

void Costmap2DROS::on_rcl_preshutdown() {
  if (!is_lifecycle_follower_) nav2_util::LifecycleNode::on_rcl_preshutdown();
}

CallbackReturn Costmap2DROS::on_configure(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Configuring");
  try {
    getParameters();
  } catch (const std::exception& error) {
    RCLCPP_ERROR(get_logger(), "Failed to configure costmap! %s.", error.what());
    return CallbackReturn::FAILURE;
  }
  callback_group_ = create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
  layered_costmap_ =
      std::make_unique<LayeredCostmap>(global_frame_, rolling_window_, track_unknown_space_);
  if (!layered_costmap_->isSizeLocked()) resizeToParameters();
  tf_buffer_ = std::make_shared<tf2_ros::Buffer>(get_clock());
  tf_buffer_->setCreateTimerInterface(std::make_shared<tf2_ros::CreateTimerROS>(
      get_node_base_interface(), get_node_timers_interface(), callback_group_));
  tf_listener_ = std::make_shared<tf2_ros::TransformListener>(*tf_buffer_);
  try {
    loadLayers();
  } catch (const std::exception&) {
    return CallbackReturn::FAILURE;
  }
  makePublishers();
  if (use_radius_) {
    setRobotFootprint(makeFootprintFromRadius(robot_radius_));
  } else {
    std::vector<geometry_msgs::msg::Point> footprint;
    makeFootprintFromString(footprint_, footprint);
    setRobotFootprint(footprint);
  }
  get_cost_service_ = create_service<nav2_msgs::srv::GetCost>(
      "get_cost_" + getName(),
      std::bind(&Costmap2DROS::getCostCallback, this, std::placeholders::_1, std::placeholders::_2,
                std::placeholders::_3));
  clear_costmap_service_ = std::make_unique<ClearCostmapService>(shared_from_this(), *this);
  executor_ = std::make_shared<rclcpp::executors::SingleThreadedExecutor>();
  executor_->add_callback_group(callback_group_, get_node_base_interface());
  executor_thread_ = std::make_unique<nav2_util::NodeThread>(executor_);
  return CallbackReturn::SUCCESS;
}

void Costmap2DROS::resizeToParameters() {
  layered_costmap_->resizeMap(static_cast<unsigned int>(map_width_meters_ / resolution_),
                              static_cast<unsigned int>(map_height_meters_ / resolution_),
                              resolution_, origin_x_, origin_y_);
}

std::shared_ptr<Layer> Costmap2DROS::loadLayer(const std::string& name) {
  try {
    return plugin_loader_.createSharedInstance(nav2_util::get_plugin_type_param(this, name));
  } catch (const std::exception& error) {
    RCLCPP_ERROR(get_logger(), "Failed to initialize costmap plugin %s! %s.", name.c_str(),
                 error.what());
    throw;
  }
}

void Costmap2DROS::loadLayers() {
  for (const std::string& name : plugin_names_) {
    RCLCPP_INFO(get_logger(), "Using plugin \"%s\"", name.c_str());
    const std::shared_ptr<Layer> layer = loadLayer(name);
    layered_costmap_->addPlugin(layer);
    layer->initialize(layered_costmap_.get(), name, tf_buffer_.get(), shared_from_this(),
                      callback_group_);
    RCLCPP_INFO(get_logger(), "Initialized plugin \"%s\"", name.c_str());
  }
  for (const std::string& name : filter_names_) {
    RCLCPP_INFO(get_logger(), "Using costmap filter \"%s\"", name.c_str());
    const std::shared_ptr<Layer> filter = loadLayer(name);
    layered_costmap_->addFilter(filter);
    filter->initialize(layered_costmap_.get(), name, tf_buffer_.get(), shared_from_this(),
                       callback_group_);
    RCLCPP_INFO(get_logger(), "Initialized costmap filter \"%s\"", name.c_str());
  }
}

void Costmap2DROS::makePublishers() {
  footprint_sub_ = create_subscription<geometry_msgs::msg::Polygon>(
      "footprint", rclcpp::SystemDefaultsQoS(),
      [this](const geometry_msgs::msg::Polygon::SharedPtr polygon) {
        setRobotFootprintPolygon(polygon);
      });
  footprint_pub_ = create_publisher<geometry_msgs::msg::PolygonStamped>(
      "published_footprint", rclcpp::SystemDefaultsQoS());
  costmap_publisher_ = std::make_unique<Costmap2DPublisher>(
      shared_from_this(), layered_costmap_->getCostmap(), global_frame_, "costmap",
      always_send_full_costmap_, map_vis_z_);
  for (const auto& layer : *layered_costmap_->getPlugins()) {
    const auto costs = std::dynamic_pointer_cast<CostmapLayer>(layer);
    if (!costs) continue;
    layer_publishers_.push_back(std::make_unique<Costmap2DPublisher>(
        shared_from_this(), costs.get(), global_frame_, layer->getName(), always_send_full_costmap_,
        map_vis_z_));
  }
}

CallbackReturn Costmap2DROS::on_activate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Activating");
  if (!waitForTransform()) return CallbackReturn::FAILURE;
  costmap_publisher_->on_activate();
  footprint_pub_->on_activate();
  for (const auto& publisher : layer_publishers_) publisher->on_activate();

  stopped_ = true;
  stop_updates_ = true;
  map_update_thread_shutdown_ = false;
  map_update_thread_ = std::make_unique<std::thread>(
      [this, frequency = map_update_frequency_] { mapUpdateLoop(frequency); });
  start();
  dyn_params_handler_ =
      add_on_set_parameters_callback([this](std::vector<rclcpp::Parameter> parameters) {
        return dynamicParametersCallback(parameters);
      });
  return CallbackReturn::SUCCESS;
}

bool Costmap2DROS::waitForTransform() {
  RCLCPP_INFO(get_logger(), "Checking transform");
  const rclcpp::Time begin = now();
  const auto patience = rclcpp::Duration::from_seconds(initial_transform_timeout_);
  std::string error;
  rclcpp::Rate rate(2.0);
  while (rclcpp::ok() &&
         !tf_buffer_->canTransform(global_frame_, robot_base_frame_, tf2::TimePointZero, &error)) {
    RCLCPP_INFO(get_logger(),
                "Timed out waiting for transform from %s to %s to become available, tf error: %s",
                robot_base_frame_.c_str(), global_frame_.c_str(), error.c_str());
    if (now() > begin + patience) {
      RCLCPP_ERROR(get_logger(),
                   "Failed to activate %s because transform from %s to %s did not become available "
                   "before timeout",
                   get_name(), robot_base_frame_.c_str(), global_frame_.c_str());
      return false;
    }
    error.clear();
    rate.sleep();
  }
  return true;
}

CallbackReturn Costmap2DROS::on_deactivate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Deactivating");
  dyn_params_handler_.reset();
  stop();
  // The thread ends after its round.
  map_update_thread_shutdown_ = true;
  if (map_update_thread_ && map_update_thread_->joinable()) map_update_thread_->join();
  map_update_thread_.reset();
  footprint_pub_->on_deactivate();
  costmap_publisher_->on_deactivate();
  for (const auto& publisher : layer_publishers_) publisher->on_deactivate();
  return CallbackReturn::SUCCESS;
}

CallbackReturn Costmap2DROS::on_cleanup(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Cleaning up");
  executor_thread_.reset();
  get_cost_service_.reset();
  costmap_publisher_.reset();
  clear_costmap_service_.reset();
  layer_publishers_.clear();
  footprint_sub_.reset();
  footprint_pub_.reset();
  layered_costmap_.reset();
  tf_listener_.reset();
  tf_buffer_.reset();
  return CallbackReturn::SUCCESS;
}

CallbackReturn Costmap2DROS::on_shutdown(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Shutting down");
  return CallbackReturn::SUCCESS;
}

void Costmap2DROS::mapUpdateLoop(double frequency) {
  // The map is updated on request only.
  if (!(frequency > 0.0)) return;
  rclcpp::WallRate rate(frequency);
  while (rclcpp::ok() && !map_update_thread_shutdown_) {
    if (!stop_updates_) {
      // Parameters do not change within a round.
      const std::lock_guard<std::mutex> lock(dynamic_parameter_mutex_);
      updateMap();
      publishCosts();
    }
    rate.sleep();
  }
}

void Costmap2DROS::publishCosts() {
  if (publish_cycle_ <= rclcpp::Duration(0, 0) || !layered_costmap_->isInitialized()) return;
  unsigned int x0;
  unsigned int xn;
  unsigned int y0;
  unsigned int yn;
  layered_costmap_->getBounds(&x0, &xn, &y0, &yn);
  costmap_publisher_->updateBounds(x0, xn, y0, yn);
  for (const auto& publisher : layer_publishers_) publisher->updateBounds(x0, xn, y0, yn);
  const rclcpp::Time current_time = now();
  const bool has_jumped_back = current_time < last_publish_;
  if (!has_jumped_back && current_time < last_publish_ + publish_cycle_) return;
  RCLCPP_DEBUG(get_logger(), "Publish costmap at %s", name_.c_str());
  costmap_publisher_->publishCostmap();
  for (const auto& publisher : layer_publishers_) publisher->publishCostmap();
  last_publish_ = current_time;
}

void Costmap2DROS::updateMap() {
  geometry_msgs::msg::PoseStamped pose;
  if (stop_updates_ || !getRobotPose(pose)) return;
  const double x = pose.pose.position.x;
  const double y = pose.pose.position.y;
  const double yaw = tf2::getYaw(pose.pose.orientation);
  layered_costmap_->updateMap(x, y, yaw);
  auto footprint = std::make_unique<geometry_msgs::msg::PolygonStamped>();
  footprint->header = pose.header;
  transformFootprint(x, y, yaw, getRobotFootprint(), *footprint);
  footprint_pub_->publish(std::move(footprint));
  initialized_ = true;
}

std::vector<std::shared_ptr<Layer>> Costmap2DROS::layersAndFilters() {
  std::vector<std::shared_ptr<Layer>> all = *layered_costmap_->getPlugins();
  const auto& filters = *layered_costmap_->getFilters();
  all.insert(all.end(), filters.begin(), filters.end());
  return all;
}

void Costmap2DROS::start() {
  RCLCPP_INFO(get_logger(), "start");
  if (stopped_) {
    for (const auto& layer : layersAndFilters()) layer->activate();
    stopped_ = false;
  }
  stop_updates_ = false;
  // Until the first round is over.
  while (rclcpp::ok() && !initialized_ && map_update_frequency_ > 0.0) {
    rclcpp::sleep_for(milliseconds(10));
  }
}

void Costmap2DROS::stop() {
  stop_updates_ = true;
  if (layered_costmap_) {
    for (const auto& layer : layersAndFilters()) layer->deactivate();
  }
  initialized_ = false;
  stopped_ = true;
}

void Costmap2DROS::pause() {
  stop_updates_ = true;
  initialized_ = false;
}

void Costmap2DROS::resume() {
  stop_updates_ = false;
  while (rclcpp::ok() && !initialized_) rclcpp::sleep_for(milliseconds(10));
}

void Costmap2DROS::resetLayers() {
  Costmap2D* top = layered_costmap_->getCostmap();
  top->resetMap(0, 0, top->getSizeInCellsX(), top->getSizeInCellsY());
  for (const auto& layer : layersAndFilters()) layer->reset();
}

bool Costmap2DROS::getRobotPose(geometry_msgs::msg::PoseStamped& global_pose) {
  return nav2_util::getCurrentPose(global_pose, *tf_buffer_, global_frame_, robot_base_frame_,
                                   transform_tolerance_);
}

bool Costmap2DROS::transformPoseToGlobalFrame(const geometry_msgs::msg::PoseStamped& input_pose,
                                              geometry_msgs::msg::PoseStamped& transformed_pose) {
  if (input_pose.header.frame_id == global_frame_) {
    transformed_pose = input_pose;
    return true;
  }
  return nav2_util::transformPoseInTargetFrame(input_pose, transformed_pose, *tf_buffer_,
                                               global_frame_, transform_tolerance_);
}

void Costmap2DROS::getOrientedFootprint(
    std::vector<geometry_msgs::msg::Point>& oriented_footprint) {
  geometry_msgs::msg::PoseStamped pose;
  if (!getRobotPose(pose)) return;
  transformFootprint(pose.pose.position.x, pose.pose.position.y, tf2::getYaw(pose.pose.orientation),
                     getRobotFootprint(), oriented_footprint);
}

void Costmap2DROS::setRobotFootprint(const std::vector<geometry_msgs::msg::Point>& points) {
  const bool is_finite = std::all_of(points.begin(), points.end(), [](const auto& point) {
    return std::isfinite(point.x) && std::isfinite(point.y);
  });
  if (points.empty() || !is_finite) {
    RCLCPP_ERROR(
        get_logger(),
        "You try to set an empty footprint this isn't allowed, a footprint must contain at "
        "least one point.");
    return;
  }
  std::vector<geometry_msgs::msg::Point> padded = points;
  padFootprint(padded, footprint_padding_);
  {
    const std::lock_guard<std::mutex> lock(footprint_mutex_);
    unpadded_footprint_ = points;
    padded_footprint_ = padded;
  }
  const std::unique_lock<Costmap2D::mutex_t> lock(*getCostmap()->getMutex());
  layered_costmap_->setFootprint(padded);
}

void Costmap2DROS::setRobotFootprintPolygon(
    const geometry_msgs::msg::Polygon::SharedPtr footprint) {
  setRobotFootprint(toPointVector(footprint));
}

void Costmap2DROS::getCostCallback(
    const std::shared_ptr<rmw_request_id_t>,
    const std::shared_ptr<nav2_msgs::srv::GetCost::Request> request,
    const std::shared_ptr<nav2_msgs::srv::GetCost::Response> response) {
  Costmap2D* costmap = getCostmap();
  if (request->use_footprint) {
    RCLCPP_INFO(get_logger(), "Received request to get cost at footprint pose (%.2f, %.2f, %.2f)",
                request->x, request->y, request->theta);
    FootprintCollisionChecker<Costmap2D*> checker(costmap);
    response->cost = static_cast<float>(
        checker.footprintCostAtPose(request->x, request->y, request->theta, getRobotFootprint()));
    return;
  }
  RCLCPP_INFO(get_logger(), "Received request to get cost at point (%f, %f)", request->x,
              request->y);
  unsigned int mx;
  unsigned int my;
  if (!costmap->worldToMap(request->x, request->y, mx, my)) {
    RCLCPP_WARN(get_logger(), "Point (%f, %f) is out of bounds", request->x, request->y);
    response->cost = -1.0F;
    return;
  }
  response->cost = static_cast<float>(costmap->getCost(mx, my));
}

}  // namespace nav2_costmap_2d
