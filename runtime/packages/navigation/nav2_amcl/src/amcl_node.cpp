// See amcl_node.hpp. The states of the node, and what it subscribes to and offers; scans are in
// scans.cpp, the map and given poses in given_poses.cpp, parameters in parameters.cpp.
#include "nav2_amcl/amcl_node.hpp"

#include <utility>

#include "nav2_util/geometry_utils.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "tf2/utils.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "tf2_ros/create_timer_ros.h"

namespace nav2_amcl {

using nav2_util::CallbackReturn;
using std::placeholders::_1;

namespace {

std::uint64_t new_seed() {
  std::random_device device;
  return static_cast<std::uint64_t>(device()) << 32U | device();
}

}  // namespace

AmclNode::AmclNode(const rclcpp::NodeOptions& options)
    : nav2_util::LifecycleNode("amcl", "", options), random_(new_seed()) {
  RCLCPP_INFO(get_logger(), "Creating");
  declareParameters();
}

AmclNode::~AmclNode() = default;

CallbackReturn AmclNode::on_configure(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Configuring");
  initParameters();
  initTransforms();
  initOdometry();
  initParticleFilter();
  scan_error_count_ = 0;
  initMessageFilters();
  initPubSub();
  initServices();
  return CallbackReturn::SUCCESS;
}

CallbackReturn AmclNode::on_activate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Activating");
  pose_pub_->on_activate();
  particle_cloud_pub_->on_activate();
  first_pose_sent_ = false;
  active_ = true;
  if (parameters_.set_initial_pose) {
    auto pose = std::make_shared<PoseWithCovariance>();
    pose->header.stamp = now();
    pose->header.frame_id = parameters_.global_frame_id;
    pose->pose.pose.position.x = parameters_.initial_x;
    pose->pose.pose.position.y = parameters_.initial_y;
    pose->pose.pose.position.z = parameters_.initial_z;
    pose->pose.pose.orientation =
        nav2_util::geometry_utils::orientationAroundZAxis(parameters_.initial_yaw);
    initialPoseReceived(pose);
  } else if (init_pose_received_on_inactive_) {
    handleInitialPose(last_published_pose_);
  }
  dyn_params_handler_ =
      add_on_set_parameters_callback([this](std::vector<rclcpp::Parameter> parameters) {
        return dynamicParametersCallback(std::move(parameters));
      });
  createBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn AmclNode::on_deactivate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Deactivating");
  active_ = false;
  pose_pub_->on_deactivate();
  particle_cloud_pub_->on_deactivate();
  dyn_params_handler_.reset();
  destroyBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn AmclNode::on_cleanup(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Cleaning up");
  global_loc_srv_.reset();
  initial_guess_srv_.reset();
  nomotion_update_srv_.reset();
  initial_pose_sub_.reset();
  map_sub_.reset();
  // The listener calls the filter of scans, so it goes first.
  tf_listener_.reset();
  laser_scan_filter_.reset();
  laser_scan_sub_.reset();
  scans_.clear();
  scanners_.clear();
  map_.reset();
  free_cells_.clear();
  tf_broadcaster_.reset();
  tf_buffer_.reset();
  pose_pub_.reset();
  particle_cloud_pub_.reset();
  motion_model_.reset();
  filter_.reset();
  force_update_ = true;
  if (parameters_.set_initial_pose) {
    const auto& pose = last_published_pose_.pose.pose;
    set_parameter(rclcpp::Parameter("initial_pose.x", pose.position.x));
    set_parameter(rclcpp::Parameter("initial_pose.y", pose.position.y));
    set_parameter(rclcpp::Parameter("initial_pose.z", pose.position.z));
    set_parameter(rclcpp::Parameter("initial_pose.yaw", tf2::getYaw(pose.orientation)));
  }
  return CallbackReturn::SUCCESS;
}

CallbackReturn AmclNode::on_shutdown(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Shutting down");
  return CallbackReturn::SUCCESS;
}

void AmclNode::initTransforms() {
  RCLCPP_INFO(get_logger(), "initTransforms");
  tf_buffer_ = std::make_shared<tf2_ros::Buffer>(get_clock());
  tf_buffer_->setCreateTimerInterface(std::make_shared<tf2_ros::CreateTimerROS>(
      get_node_base_interface(), get_node_timers_interface()));
  tf_listener_ = std::make_shared<tf2_ros::TransformListener>(*tf_buffer_, this, true);
  tf_broadcaster_ = std::make_shared<tf2_ros::TransformBroadcaster>(shared_from_this());
  sent_first_transform_ = false;
  map_to_odom_.reset();
}

void AmclNode::initOdometry() {
  motion_model_ = plugin_loader_.createSharedInstance(parameters_.robot_model_type);
  motion_model_->initialize(parameters_.alpha1, parameters_.alpha2, parameters_.alpha3,
                            parameters_.alpha4, parameters_.alpha5);
}

void AmclNode::initParticleFilter() {
  // A node that is configured again begins where it was.
  const auto& last = last_published_pose_.pose;
  const pf_vector_t mean{
      {last.pose.position.x, last.pose.position.y, tf2::getYaw(last.pose.orientation)}};
  pf_matrix_t covariance{};
  covariance.m[0][0] = initial_pose_is_known_ ? last.covariance[0] : 0.5 * 0.5;
  covariance.m[1][1] = initial_pose_is_known_ ? last.covariance[7] : 0.5 * 0.5;
  covariance.m[2][2] = initial_pose_is_known_ ? last.covariance[35] : (M_PI / 12) * (M_PI / 12);
  filter_ = std::make_unique<ParticleFilter>(parameters_.filter, random_);
  filter_->reset(mean, covariance);
  has_odom_pose_ = false;
  resample_count_ = 0;
}

void AmclNode::initMessageFilters() {
  laser_scan_sub_ =
      std::make_unique<message_filters::Subscriber<LaserScan, rclcpp_lifecycle::LifecycleNode>>(
          shared_from_this(), parameters_.scan_topic, rmw_qos_profile_sensor_data);
  laser_scan_filter_ = std::make_unique<tf2_ros::MessageFilter<LaserScan>>(
      *laser_scan_sub_, *tf_buffer_, parameters_.odom_frame_id, 10, get_node_logging_interface(),
      get_node_clock_interface(), tf2::durationFromSec(parameters_.transform_tolerance));
  laser_scan_filter_->registerCallback(
      [this](LaserScan::ConstSharedPtr scan) { laserReceived(scan); });
}

void AmclNode::initPubSub() {
  RCLCPP_INFO(get_logger(), "initPubSub");
  particle_cloud_pub_ =
      create_publisher<nav2_msgs::msg::ParticleCloud>("particle_cloud", rclcpp::SensorDataQoS());
  pose_pub_ = create_publisher<PoseWithCovariance>(
      "amcl_pose", rclcpp::QoS(rclcpp::KeepLast(1)).transient_local().reliable());
  initial_pose_sub_ =
      create_subscription<PoseWithCovariance>("initialpose", rclcpp::SystemDefaultsQoS(),
                                              std::bind(&AmclNode::initialPoseReceived, this, _1));
  subscribeToMap();
  RCLCPP_INFO(get_logger(), "Subscribed to map topic.");
}

void AmclNode::subscribeToMap() {
  map_sub_ = create_subscription<nav_msgs::msg::OccupancyGrid>(
      parameters_.map_topic, rclcpp::QoS(rclcpp::KeepLast(1)).transient_local().reliable(),
      std::bind(&AmclNode::mapReceived, this, _1));
}

void AmclNode::initServices() {
  using Empty = std_srvs::srv::Empty;
  using SetInitialPose = nav2_msgs::srv::SetInitialPose;
  global_loc_srv_ = create_service<Empty>(
      "reinitialize_global_localization",
      [this](Empty::Request::SharedPtr, Empty::Response::SharedPtr) { globalLocalization(); });
  initial_guess_srv_ = create_service<SetInitialPose>(
      "set_initial_pose",
      [this](SetInitialPose::Request::SharedPtr request, SetInitialPose::Response::SharedPtr) {
        initialPoseReceived(std::make_shared<PoseWithCovariance>(request->pose));
      });
  nomotion_update_srv_ = create_service<Empty>(
      "request_nomotion_update", [this](Empty::Request::SharedPtr, Empty::Response::SharedPtr) {
        RCLCPP_INFO(get_logger(), "Requesting no-motion update");
        force_update_ = true;
      });
}

bool AmclNode::mayRemind() {
  if ((now() - last_reminder_).seconds() <= 2.0) return false;
  last_reminder_ = now();
  return true;
}

}  // namespace nav2_amcl

RCLCPP_COMPONENTS_REGISTER_NODE(nav2_amcl::AmclNode)
