// See slam_toolbox_common.hpp. The states of the node, and what it offers.
#include "node/slam_toolbox_common.hpp"

#include <chrono>

#include "bond/msg/constants.hpp"
#include "lifecycle_msgs/msg/state.hpp"
#include "tf2_ros/create_timer_ros.h"

namespace slam_toolbox {
namespace {

using lifecycle_msgs::msg::State;
using rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface;

constexpr std::chrono::seconds kPatience{3};

rclcpp::QoS latched() {
  return rclcpp::QoS(rclcpp::KeepLast(1)).transient_local().reliable();
}

}  // namespace

SlamToolbox::SlamToolbox(const rclcpp::NodeOptions& options)
    : rclcpp_lifecycle::LifecycleNode("slam_toolbox", "", options) {
  // A manager that is busy is not dead.
  declare_parameter(bond::msg::Constants::DISABLE_HEARTBEAT_TIMEOUT_PARAM, true);
  // Launch files of Jazzy set this parameter, and configure and activate the node. Those of Humble
  // start a node that was not managed yet.
  const auto& given = get_node_parameters_interface()->get_parameter_overrides();
  if (given.count("use_lifecycle_manager") > 0) return;
  self_start_timer_ = create_wall_timer(kPatience, [this] { start_by_itself(); });
}

void SlamToolbox::start_by_itself() {
  self_start_timer_->cancel();
  if (get_current_state().id() != State::PRIMARY_STATE_UNCONFIGURED) return;
  RCLCPP_WARN(
      get_logger(),
      "This node was not configured within 3 s, so it configures and activates itself, as in "
      "Humble. On a robot with Jazzy, include online_async_launch.py, or configure and "
      "activate the node.");
  if (configure().id() == State::PRIMARY_STATE_INACTIVE) activate();
}

LifecycleNodeInterface::CallbackReturn SlamToolbox::on_configure(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Configuring");
  parameters_ = read_parameters(*this);
  if (parameters_.debug_logging) get_logger().set_level(rclcpp::Logger::Level::Debug);
  forget();
  map_from_odom_.setIdentity();
  set_paused(false);
  create_interfaces();
  create_services();
  load_given_session();
  return CallbackReturn::SUCCESS;
}

void SlamToolbox::forget() {
  mapper_ = std::make_unique<Mapper>(parameters_.mapper);
  coverage_ = std::make_unique<Coverage>(parameters_.resolution);
  drawn_scans_ = published_scans_ = 0;
  drawn_revision_ = published_revision_ = 0;
  is_too_large_ = false;
  start_ = Start::kOdometry;
  checked_odometry_.reset();
  scan_count_ = 0;
}

void SlamToolbox::create_interfaces() {
  buffer_ = std::make_unique<tf2_ros::Buffer>(get_clock(),
                                              tf2::durationFromSec(parameters_.tf_buffer_duration));
  buffer_->setCreateTimerInterface(std::make_shared<tf2_ros::CreateTimerROS>(
      get_node_base_interface(), get_node_timers_interface()));
  listener_ = std::make_unique<tf2_ros::TransformListener>(*buffer_, this, false);
  broadcaster_ = std::make_unique<tf2_ros::TransformBroadcaster>(*this);
  pose_publisher_ = create_publisher<geometry_msgs::msg::PoseWithCovarianceStamped>("pose", 10);
  map_publisher_ = create_publisher<nav_msgs::msg::OccupancyGrid>(parameters_.map_name, latched());
  metadata_publisher_ =
      create_publisher<nav_msgs::msg::MapMetaData>(parameters_.map_name + "_metadata", latched());
  graph_publisher_ = create_publisher<visualization_msgs::msg::MarkerArray>(
      "slam_toolbox/graph_visualization", 10);
}

void SlamToolbox::create_services() {
  const auto offer = [this](auto service) { services_.push_back(service); };
  if (parameters_.use_map_saver) {
    using Service = srv::SaveMap;
    offer(create_service<Service>(
        "slam_toolbox/save_map",
        [this](const Service::Request::SharedPtr request, Service::Response::SharedPtr response) {
          save_map(*request, *response);
        }));
  }
  using GetMap = nav_msgs::srv::GetMap;
  offer(create_service<GetMap>(
      "slam_toolbox/dynamic_map",
      [this](const GetMap::Request::SharedPtr, GetMap::Response::SharedPtr response) {
        const std::lock_guard<std::recursive_mutex> lock(mutex_);
        response->map = map_message();
      }));
  using Pause = srv::Pause;
  offer(create_service<Pause>("slam_toolbox/pause_new_measurements",
                              [this](const Pause::Request::SharedPtr,
                                     Pause::Response::SharedPtr response) { pause(*response); }));
  using Reset = srv::Reset;
  offer(create_service<Reset>("slam_toolbox/reset", [this](const Reset::Request::SharedPtr request,
                                                           Reset::Response::SharedPtr response) {
    reset_map(*request, *response);
  }));
  using Serialize = srv::SerializePoseGraph;
  offer(create_service<Serialize>(
      "slam_toolbox/serialize_map",
      [this](const Serialize::Request::SharedPtr request, Serialize::Response::SharedPtr response) {
        serialize(*request, *response);
      }));
  using Deserialize = srv::DeserializePoseGraph;
  offer(create_service<Deserialize>(
      "slam_toolbox/deserialize_map",
      [this](const Deserialize::Request::SharedPtr request, Deserialize::Response::SharedPtr) {
        const auto& pose = request->initial_pose;
        deserialize(request->filename, request->match_type, {pose.x, pose.y, pose.theta});
      }));
}

LifecycleNodeInterface::CallbackReturn SlamToolbox::on_activate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Activating");
  pose_publisher_->on_activate();
  map_publisher_->on_activate();
  metadata_publisher_->on_activate();
  graph_publisher_->on_activate();
  is_active_ = true;
  scan_subscriber_ =
      std::make_unique<message_filters::Subscriber<LaserScan, rclcpp_lifecycle::LifecycleNode>>(
          shared_from_this(), parameters_.scan_topic, rmw_qos_profile_sensor_data);
  scan_filter_ = std::make_unique<tf2_ros::MessageFilter<LaserScan>>(
      *scan_subscriber_, *buffer_, parameters_.odom_frame,
      static_cast<uint32_t>(parameters_.scan_queue_size), get_node_logging_interface(),
      get_node_clock_interface(), tf2::durationFromSec(parameters_.transform_timeout));
  scan_filter_->registerCallback([this](LaserScan::ConstSharedPtr scan) { on_scan(*scan); });
  // Wall time, as upstream: stamps come from scans, and there may be no /clock.
  const auto every = [this](double seconds, auto callback) {
    return create_wall_timer(std::chrono::duration<double>(seconds), callback);
  };
  if (parameters_.transform_publish_period > 0.0) {
    transform_timer_ = every(parameters_.transform_publish_period, [this] { publish_transform(); });
  }
  map_timer_ = every(parameters_.map_update_interval, [this] {
    publish_map();
    publish_graph();
  });
  if (parameters_.use_lifecycle_manager) {
    bond_ = std::make_unique<bond::Bond>("bond", get_name(), shared_from_this());
    bond_->setHeartbeatPeriod(0.10);
    bond_->setHeartbeatTimeout(4.0);
    bond_->start();
  }
  // A session that was read has a map already.
  publish_map();
  return CallbackReturn::SUCCESS;
}

LifecycleNodeInterface::CallbackReturn SlamToolbox::on_deactivate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Deactivating");
  is_active_ = false;
  scan_filter_.reset();
  scan_subscriber_.reset();
  transform_timer_.reset();
  map_timer_.reset();
  pose_publisher_->on_deactivate();
  map_publisher_->on_deactivate();
  metadata_publisher_->on_deactivate();
  graph_publisher_->on_deactivate();
  bond_.reset();
  return CallbackReturn::SUCCESS;
}

LifecycleNodeInterface::CallbackReturn SlamToolbox::on_cleanup(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Cleaning up");
  services_.clear();
  listener_.reset();
  broadcaster_.reset();
  buffer_.reset();
  pose_publisher_.reset();
  map_publisher_.reset();
  metadata_publisher_.reset();
  graph_publisher_.reset();
  drop_taken();
  mounts_.clear();
  mapper_.reset();
  coverage_.reset();
  has_scan_ = false;
  return CallbackReturn::SUCCESS;
}

LifecycleNodeInterface::CallbackReturn SlamToolbox::on_shutdown(
    const rclcpp_lifecycle::State& state) {
  RCLCPP_INFO(get_logger(), "Shutting down");
  if (state.id() == State::PRIMARY_STATE_ACTIVE) on_deactivate(state);
  if (state.id() != State::PRIMARY_STATE_UNCONFIGURED) on_cleanup(state);
  return CallbackReturn::SUCCESS;
}

}  // namespace slam_toolbox
