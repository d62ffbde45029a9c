// Finds where a robot is on a map, from laser scans and odometry, and publishes it as a pose, a
// cloud of particles, and the transform from the map to odometry.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "geometry_msgs/msg/pose_with_covariance_stamped.hpp"
#include "message_filters/subscriber.h"
#include "nav2_amcl/amcl_parameters.hpp"
#include "nav2_amcl/map/occupancy_map.hpp"
#include "nav2_amcl/motion_model/motion_model.hpp"
#include "nav2_amcl/pf/particle_filter.hpp"
#include "nav2_amcl/sensors/laser_model.hpp"
#include "nav2_msgs/msg/particle_cloud.hpp"
#include "nav2_msgs/srv/set_initial_pose.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "nav_msgs/msg/occupancy_grid.hpp"
#include "pluginlib/class_loader.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "std_srvs/srv/empty.hpp"
#include "tf2/LinearMath/Transform.h"
#include "tf2_ros/buffer.h"
#include "tf2_ros/message_filter.h"
#include "tf2_ros/transform_broadcaster.h"
#include "tf2_ros/transform_listener.h"

namespace nav2_amcl {

/// Without a thread of its own: all work is done by the executor that spins the node.
class AmclNode : public nav2_util::LifecycleNode {
 public:
  explicit AmclNode(const rclcpp::NodeOptions& options = rclcpp::NodeOptions());
  ~AmclNode();

 protected:
  using LaserScan = sensor_msgs::msg::LaserScan;
  using PoseWithCovariance = geometry_msgs::msg::PoseWithCovarianceStamped;

  nav2_util::CallbackReturn on_configure(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_activate(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_deactivate(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_cleanup(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_shutdown(const rclcpp_lifecycle::State& state) override;

  void mapReceived(const nav_msgs::msg::OccupancyGrid::SharedPtr msg);
  void laserReceived(LaserScan::ConstSharedPtr laser_scan);
  void initialPoseReceived(PoseWithCovariance::SharedPtr msg);
  void handleInitialPose(const PoseWithCovariance& msg);
  void globalLocalization();
  rcl_interfaces::msg::SetParametersResult dynamicParametersCallback(
      std::vector<rclcpp::Parameter> parameters);

 private:
  /// A scanner, by the frame of its scans.
  struct Scanner {
    std::unique_ptr<LaserModel> model;
    bool needs_update = true;
  };

  void declareParameters();
  void initParameters();
  /// Empty when the parameters can be used; else why not.
  std::string refusal(const AmclParameters& parameters);
  void raiseNegativeAlphas(AmclParameters& parameters);
  void initTransforms();
  void initOdometry();
  void initParticleFilter();
  void initMessageFilters();
  void initPubSub();
  void initServices();
  void subscribeToMap();
  void renew(const Renewal& renewal);

  void handleScan(const LaserScan& scan);
  Scanner* scannerOf(const LaserScan& scan);
  std::unique_ptr<LaserModel> makeLaserModel(const std::string& laser_frame);
  bool getOdomPose(const LaserScan& scan, tf2::Transform& odom_to_base);
  bool shouldUpdateFilter(const pf_vector_t& delta) const;
  std::optional<LaserData> readScan(const LaserScan& scan);
  pf_vector_t randomFreePose(Random& random) const;
  MakePose randomPoses() const;

  void publishParticleCloud();
  void publishEstimate(const LaserScan& scan, const tf2::Transform& odom_to_base);
  bool publishAmclPose(const LaserScan& scan, const PoseEstimate& best);
  void sendMapToOdomTransform(const LaserScan& scan);
  /// True at most every 2 s.
  bool mayRemind();

  AmclParameters parameters_;
  // The generator of all random numbers of the node: a stepped run repeats with its seed.
  Random random_;
  std::recursive_mutex mutex_;
  bool active_ = false;
  bool is_working_ = false;
  std::deque<LaserScan::ConstSharedPtr> scans_;  // that came meanwhile

  std::shared_ptr<OccupancyMap> map_;
  std::vector<std::uint32_t> free_cells_;
  std::map<std::string, Scanner> scanners_;
  std::unique_ptr<ParticleFilter> filter_;
  // Before the model, whose code it has.
  pluginlib::ClassLoader<MotionModel> plugin_loader_{"nav2_amcl", "nav2_amcl::MotionModel"};
  std::shared_ptr<MotionModel> motion_model_;

  bool has_odom_pose_ = false;
  pf_vector_t odom_pose_{};  // at the last update
  int resample_count_ = 0;
  int scan_error_count_ = 0;
  bool force_update_ = false;
  bool first_pose_sent_ = false;
  bool initial_pose_is_known_ = false;
  bool init_pose_received_on_inactive_ = false;
  PoseWithCovariance last_published_pose_;
  std::optional<tf2::Transform> map_to_odom_;
  bool sent_first_transform_ = false;
  rclcpp::Time last_reminder_;

  std::shared_ptr<tf2_ros::Buffer> tf_buffer_;
  std::shared_ptr<tf2_ros::TransformListener> tf_listener_;
  std::shared_ptr<tf2_ros::TransformBroadcaster> tf_broadcaster_;
  std::unique_ptr<message_filters::Subscriber<LaserScan, rclcpp_lifecycle::LifecycleNode>>
      laser_scan_sub_;
  std::unique_ptr<tf2_ros::MessageFilter<LaserScan>> laser_scan_filter_;
  rclcpp::Subscription<nav_msgs::msg::OccupancyGrid>::SharedPtr map_sub_;
  rclcpp::Subscription<PoseWithCovariance>::SharedPtr initial_pose_sub_;
  rclcpp_lifecycle::LifecyclePublisher<PoseWithCovariance>::SharedPtr pose_pub_;
  rclcpp_lifecycle::LifecyclePublisher<nav2_msgs::msg::ParticleCloud>::SharedPtr
      particle_cloud_pub_;
  rclcpp::Service<std_srvs::srv::Empty>::SharedPtr global_loc_srv_;
  rclcpp::Service<std_srvs::srv::Empty>::SharedPtr nomotion_update_srv_;
  rclcpp::Service<nav2_msgs::srv::SetInitialPose>::SharedPtr initial_guess_srv_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr dyn_params_handler_;
};

}  // namespace nav2_amcl
