// Readings of sensors in the frames of the filter: transforms, mounting, differences. Without ROS.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "filter/measurement.hpp"

namespace robot_localization {

/// A pose as a sensor reports it.
struct PoseReading {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  Matrix6 covariance = Matrix6::Zero();
  /// From the frame of the message to that of the filter; of an IMU, from its frame to the base.
  Eigen::Isometry3d target_from_message = Eigen::Isometry3d::Identity();
  /// From the base to the frame whose pose it is, when that is not the base itself.
  std::optional<Eigen::Isometry3d> child_from_base;
  bool is_imu = false;  ///< the orientation is that of the IMU, which the robot carries
  bool is_differential = false;
  bool is_relative = false;
};

/// Velocities in the frame of the sensor.
struct TwistReading {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();
  Matrix6 covariance = Matrix6::Zero();
  Eigen::Isometry3d base_from_sensor = Eigen::Isometry3d::Identity();
};

struct AccelerationReading {
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  Eigen::Isometry3d base_from_sensor = Eigen::Isometry3d::Identity();
  /// In the frame of the sensor; zero when the driver has removed it.
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
};

/// How the base turns, which moves a sensor that is not in its origin.
struct Turning {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();      ///< [rad/s]
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  ///< [rad/s^2]
};

/// The flat motion of `two_d_mode`: all that leaves the plane is measured as zero.
void force_two_d(Measurement& measurement);

// Each of these reads `update` of the measurement and changes it to the variables that the reading
// has in the frames of the filter.
void take_twist(const TwistReading& reading, const Turning& turning, Measurement& measurement);
void take_acceleration(const AccelerationReading& reading, const Turning& turning,
                       Measurement& measurement);

/// Poses of one topic, of which differences and the way from the first are taken.
class PoseSource {
 public:
  /// False when there is nothing to fuse yet: a difference needs two poses with different times,
  /// also rotations, and a first pose needs a rotation and the places that the configuration uses.
  bool take(const PoseReading& reading, const Turning& turning, Measurement& measurement);

 private:
  struct Timed {
    Eigen::Isometry3d pose;
    Matrix6 covariance;
    int64_t time_ns;
    Variables known;  ///< those of the pose whose value and variance are finite
  };

  bool take_difference(const PoseReading& reading, const Timed& now, const Turning& turning,
                       Measurement& measurement);

  std::optional<Timed> previous_;
  std::optional<Eigen::Isometry3d> first_;
};

/// The orientation of a level robot that carries an IMU, from the IMU's own: its mounting is taken
/// off, and roll and pitch are turned with the mounting's yaw.
Eigen::Matrix3d without_mounting(const Eigen::Matrix3d& imu, const Eigen::Matrix3d& base_from_imu);

/// The acceleration that an IMU at rest measures, in its own frame.
Eigen::Vector3d gravity_in(const Eigen::Matrix3d& world_from_sensor, double gravity);

}  // namespace robot_localization
