// The node around a mapper: a managed node that makes a map of the scans of a laser, and publishes
// it with the frame of the map.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "bondcpp/bond.hpp"
#include "core/coverage.hpp"
#include "geometry_msgs/msg/pose_with_covariance_stamped.hpp"
#include "message_filters/subscriber.h"
#include "nav_msgs/msg/map_meta_data.hpp"
#include "nav_msgs/msg/occupancy_grid.hpp"
#include "nav_msgs/srv/get_map.hpp"
#include "node/parameters.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "slam_toolbox/srv/deserialize_pose_graph.hpp"
#include "slam_toolbox/srv/pause.hpp"
#include "slam_toolbox/srv/reset.hpp"
#include "slam_toolbox/srv/save_map.hpp"
#include "slam_toolbox/srv/serialize_pose_graph.hpp"
#include "tf2_ros/buffer.h"
#include "tf2_ros/message_filter.h"
#include "tf2_ros/transform_broadcaster.h"
#include "tf2_ros/transform_listener.h"
#include "visualization_msgs/msg/marker_array.hpp"

namespace slam_toolbox {

class SlamToolbox : public rclcpp_lifecycle::LifecycleNode {
 public:
  explicit SlamToolbox(const rclcpp::NodeOptions& options);

 protected:
  using CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;
  using LaserScan = sensor_msgs::msg::LaserScan;

  CallbackReturn on_configure(const rclcpp_lifecycle::State& state) override;
  CallbackReturn on_activate(const rclcpp_lifecycle::State& state) override;
  CallbackReturn on_deactivate(const rclcpp_lifecycle::State& state) override;
  CallbackReturn on_cleanup(const rclcpp_lifecycle::State& state) override;
  CallbackReturn on_shutdown(const rclcpp_lifecycle::State& state) override;

  /// A scan whose odometry is known.
  virtual void take(Scan scan) = 0;
  /// Forgets scans that were taken and not added.
  virtual void drop_taken() {}
  /// The first scan, also that of a session, is added nevertheless.
  bool is_paused() const;
  /// True when enough time has passed since the last scan for which it was, and it has moved.
  bool should_process(const Scan& scan);
  void add(Scan scan);

  std::recursive_mutex mutex_;

 private:
  /// Where the next scan belongs.
  enum class Start { kOdometry, kFirstScan, kGivenPose };
  /// Where a laser is mounted.
  struct Mount {
    tf2::Transform base_from_laser;
    double max_range;  ///< [m]
  };

  // States (slam_toolbox_common.cpp).
  void start_by_itself();
  void create_interfaces();
  void create_services();
  void forget();

  // Scans (scans.cpp).
  void on_scan(const LaserScan& message);
  const Mount* mount_of(const LaserScan& message);
  std::optional<Scan> read(const LaserScan& message);
  void publish_pose(const Scan& scan, const Eigen::Matrix3d& covariance);
  void publish_transform();

  // The map and sessions (maps.cpp).
  void draw();
  nav_msgs::msg::OccupancyGrid map_message();
  void publish_map();
  void publish_graph();
  void save_map(const srv::SaveMap::Request& request, srv::SaveMap::Response& response);
  void pause(srv::Pause::Response& response);
  void reset_map(const srv::Reset::Request& request, srv::Reset::Response& response);
  void serialize(const srv::SerializePoseGraph::Request& request,
                 srv::SerializePoseGraph::Response& response);
  void deserialize(const std::string& filename, int8_t match_type, const Pose& pose);
  void load_given_session();
  void set_paused(bool is_paused);

  Parameters parameters_;
  std::unique_ptr<Mapper> mapper_;
  std::unique_ptr<Coverage> coverage_;
  size_t drawn_scans_ = 0;  ///< of the coverage
  int drawn_revision_ = 0;
  size_t published_scans_ = 0;  ///< of the last map, as the next
  int published_revision_ = 0;
  size_t map_listeners_ = 0;
  bool is_too_large_ = false;  ///< the map, which was logged

  std::map<std::string, Mount> mounts_;  ///< by the frame of their scans
  bool is_active_ = false;
  bool is_paused_ = false;
  Start start_ = Start::kOdometry;
  Pose start_pose_;
  std::optional<Pose> checked_odometry_;  ///< of the last scan that should be processed
  int64_t checked_ns_ = 0;
  int scan_count_ = 0;
  tf2::Transform map_from_odom_;
  builtin_interfaces::msg::Time scan_stamp_;
  bool has_scan_ = false;

  std::unique_ptr<tf2_ros::Buffer> buffer_;
  std::unique_ptr<tf2_ros::TransformListener> listener_;
  std::unique_ptr<tf2_ros::TransformBroadcaster> broadcaster_;
  std::unique_ptr<message_filters::Subscriber<LaserScan, rclcpp_lifecycle::LifecycleNode>>
      scan_subscriber_;
  std::unique_ptr<tf2_ros::MessageFilter<LaserScan>> scan_filter_;
  rclcpp_lifecycle::LifecyclePublisher<geometry_msgs::msg::PoseWithCovarianceStamped>::SharedPtr
      pose_publisher_;
  rclcpp_lifecycle::LifecyclePublisher<nav_msgs::msg::OccupancyGrid>::SharedPtr map_publisher_;
  rclcpp_lifecycle::LifecyclePublisher<nav_msgs::msg::MapMetaData>::SharedPtr metadata_publisher_;
  rclcpp_lifecycle::LifecyclePublisher<visualization_msgs::msg::MarkerArray>::SharedPtr
      graph_publisher_;
  std::vector<rclcpp::ServiceBase::SharedPtr> services_;
  rclcpp::TimerBase::SharedPtr transform_timer_;
  rclcpp::TimerBase::SharedPtr map_timer_;
  rclcpp::TimerBase::SharedPtr self_start_timer_;
  std::unique_ptr<bond::Bond> bond_;
};

}  // namespace slam_toolbox
