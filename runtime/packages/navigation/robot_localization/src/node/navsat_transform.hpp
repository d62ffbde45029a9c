// Turns positions of GNSS into poses of the world frame, and poses into positions.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geo/cartesian_frame.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "node/transforms.hpp"
#include "rclcpp/rclcpp.hpp"
#include "robot_localization/srv/from_ll.hpp"
#include "robot_localization/srv/from_ll_array.hpp"
#include "robot_localization/srv/set_datum.hpp"
#include "robot_localization/srv/set_utm_zone.hpp"
#include "robot_localization/srv/to_ll.hpp"
#include "robot_localization/srv/to_ll_array.hpp"
#include "sensor_msgs/msg/imu.hpp"
#include "sensor_msgs/msg/nav_sat_fix.hpp"
#include "tf2_ros/static_transform_broadcaster.h"

namespace robot_localization {

class NavSatTransform : public rclcpp::Node {
 public:
  NavSatTransform();

 private:
  using Fix = sensor_msgs::msg::NavSatFix;
  using Imu = sensor_msgs::msg::Imu;
  using Odometry = nav_msgs::msg::Odometry;

  /// A position that came, in flat coordinates.
  struct Position {
    Eigen::Vector3d point;
    Eigen::Matrix3d covariance;
    rclcpp::Time stamp;
    bool is_published = false;
  };
  struct Pose {
    Eigen::Isometry3d pose;
    Eigen::Matrix3d covariance;
    rclcpp::Time stamp;
    bool is_published = false;
  };
  struct Datum {
    GeoPoint place;
    Eigen::Quaterniond orientation;
  };

  void read_parameters();
  void create_services();
  void subscribe();
  void subscribe_imu();

  void on_fix(const Fix& message);
  void on_imu(const Imu& message);
  void on_odometry(const Odometry& message);
  /// Takes the mounting of the IMU off.
  void take_orientation(const geometry_msgs::msg::Quaternion& orientation, const std::string& frame,
                        const rclcpp::Time& stamp);

  void update();
  void compute_transform();
  void take_manual_datum();
  /// The place of the robot, when a position is that of its antenna.
  Eigen::Vector3d robot_in_cartesian(const Eigen::Vector3d& antenna, double heading) const;
  Eigen::Vector3d robot_in_world(const Eigen::Vector3d& antenna, const rclcpp::Time& stamp);
  void broadcast_transform();
  void publish_gps_odometry();
  void publish_filtered_gps();

  std::optional<GeoPoint> to_geo(const Eigen::Vector3d& world_point) const;
  std::optional<Eigen::Vector3d> from_geo(const GeoPoint& place) const;
  // For services: a place that cannot be converted is logged, and is zero in the answer.
  void answer_to_geo(const geometry_msgs::msg::Point& point,
                     geographic_msgs::msg::GeoPoint& place) const;
  void answer_from_geo(const geographic_msgs::msg::GeoPoint& place,
                       geometry_msgs::msg::Point& point) const;
  void set_zone(const std::string& name);
  double flattened(double z) const { return is_flat_ ? 0.0 : z; }

  double frequency_ = 10.0;  ///< [Hz]
  double magnetic_declination_ = 0.0;
  double yaw_offset_ = 0.0;
  double transform_timeout_ = 0.0;
  bool is_flat_ = false;
  bool publishes_gps_ = true;
  bool uses_odometry_yaw_ = false;
  bool broadcasts_ = false;
  bool broadcasts_as_parent_ = false;

  Transforms transforms_;
  std::unique_ptr<CartesianFrame> cartesian_;
  std::string world_frame_ = "odom";
  std::string base_link_frame_ = "base_link";
  std::string antenna_frame_;
  std::optional<Datum> datum_;  ///< one that a user gave
  // The transform needs all three of these, of about the same time.
  std::optional<Eigen::Isometry3d> first_pose_;
  std::optional<Eigen::Vector3d> first_position_;
  std::optional<Eigen::Quaterniond> orientation_;
  std::optional<Eigen::Isometry3d> world_from_cartesian_;
  std::optional<Position> position_;
  std::optional<Pose> pose_;

  tf2_ros::StaticTransformBroadcaster broadcaster_;
  std::vector<rclcpp::ServiceBase::SharedPtr> services_;
  std::vector<rclcpp::SubscriptionBase::SharedPtr> subscriptions_;
  rclcpp::SubscriptionBase::SharedPtr imu_subscription_;
  rclcpp::Publisher<Odometry>::SharedPtr odometry_publisher_;
  rclcpp::Publisher<Fix>::SharedPtr fix_publisher_;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace robot_localization
