// See filter_node.hpp: messages become measurements.
#include <cmath>
#include <limits>
#include <utility>

#include "node/filter_node.hpp"

namespace robot_localization {
namespace {

using Imu = sensor_msgs::msg::Imu;

/// A driver says so that it measures no such thing.
template <typename Matrix>
bool is_missing(const Matrix& covariance) {
  return std::abs(covariance[0] + 1.0) < 1e-9;
}

/// Three by three in the lower right of six by six.
template <typename Small, typename Large>
void copy_angular(const Small& from, Large& to) {
  for (size_t i = 0; i < 3; ++i) {
    for (size_t j = 0; j < 3; ++j) to[6 * (i + 3) + j + 3] = from[3 * i + j];
  }
}

}  // namespace

FilterNode::Input& FilterNode::add_input(const InputParameters& settings) {
  const Variables pose = settings.config & kPoseVariables;
  const Variables acceleration = settings.config & three_from(kAx);
  const Variables twist = settings.config & ~pose & ~acceleration;
  Input& input = inputs_.emplace_back();
  input.settings = settings;
  input.pose = {settings.name + "_pose", pose, settings.pose_threshold, {}, {}};
  input.twist = {settings.name + "_twist", twist, settings.twist_threshold, {}, {}};
  input.acceleration = {
      settings.name + "_acceleration", acceleration, settings.acceleration_threshold, {}, {}};
  return input;
}

void FilterNode::subscribe() {
  const auto listen = [this]<typename Message>(const InputParameters& settings, auto callback,
                                               const Message*) {
    if (settings.config.none()) return;
    Input& input = add_input(settings);
    input.subscription = create_subscription<Message>(
        settings.topic, rclcpp::SensorDataQoS(rclcpp::KeepLast(settings.queue_size)),
        [&input, callback](const Message& message) { callback(input, message); });
  };
  const nav_msgs::msg::Odometry* odometry = nullptr;
  for (const InputParameters& settings : parameters_.odoms) {
    listen(
        settings, [this](Input& input, const auto& message) { on_odometry(input, message); },
        odometry);
  }
  const PoseMessage* pose = nullptr;
  for (const InputParameters& settings : parameters_.poses) {
    listen(
        settings,
        [this](Input& input, const auto& message) {
          on_pose(input, input.pose, message,
                  {parameters_.world_frame, parameters_.base_link_frame});
        },
        pose);
  }
  const geometry_msgs::msg::TwistWithCovarianceStamped* twist = nullptr;
  for (const InputParameters& settings : parameters_.twists) {
    listen(
        settings, [this](Input& input, const auto& message) { on_twist(input.twist, message); },
        twist);
  }
  const Imu* imu = nullptr;
  for (const InputParameters& settings : parameters_.imus) {
    listen(
        settings, [this](Input& input, const auto& message) { on_imu(input, message); }, imu);
  }
  if (parameters_.control) subscribe_control();
}

void FilterNode::subscribe_control() {
  if (!parameters_.is_control_stamped) {
    control_subscription_ = create_subscription<geometry_msgs::msg::Twist>(
        "cmd_vel", rclcpp::QoS(1),
        [this](const geometry_msgs::msg::Twist& message) { take_control(message, now()); });
    return;
  }
  using Stamped = geometry_msgs::msg::TwistStamped;
  control_subscription_ =
      create_subscription<Stamped>("cmd_vel", rclcpp::QoS(1), [this](const Stamped& message) {
        const std::string& frame = message.header.frame_id;
        if (frame.empty() || frame == parameters_.base_link_frame) {
          take_control(message.twist, message.header.stamp);
          return;
        }
        RCLCPP_WARN_THROTTLE(get_logger(), *get_clock(), 5000,
                             "Commanded velocities must be given in the robot's body frame (%s). "
                             "Message frame was %s",
                             parameters_.base_link_frame.c_str(), frame.c_str());
      });
}

void FilterNode::take_control(const geometry_msgs::msg::Twist& twist, const rclcpp::Time& stamp) {
  reset_after_jump();
  Control control;
  control.velocity << vector_of(twist.linear), vector_of(twist.angular);
  if (!control.velocity.allFinite()) return;
  control.time_ns = stamp.nanoseconds();
  estimator_.filter().set_control(control);
}

/// Nothing when the message is older than one before it, or than the last set_pose.
std::optional<Measurement> FilterNode::begin(Part& part,
                                             const builtin_interfaces::msg::Time& stamp) {
  reset_after_jump();
  const int64_t time_ns = rclcpp::Time(stamp).nanoseconds();
  const auto ignore = [&](const std::string& before) {
    report_.warn(part.name + "_timestamp",
                 "The " + part.name + " message has a timestamp " + before +
                     ", this message will be ignored. This may indicate an empty or bad "
                     "timestamp. (message time: " +
                     std::to_string(rclcpp::Time(stamp).seconds()) + ")");
  };
  if (set_pose_ns_ >= time_ns) {
    ignore("equal to or before the last filter reset");
    return std::nullopt;
  }
  if (part.newest_ns && *part.newest_ns > time_ns) {
    ignore("before that of the previous message received");
    return std::nullopt;
  }
  part.newest_ns = time_ns;
  Measurement measurement;
  measurement.source = part.name;
  measurement.time_ns = time_ns;
  measurement.update = part.update;
  measurement.rejection_threshold = part.threshold;
  return measurement;
}

void FilterNode::enqueue(Measurement measurement) {
  if (parameters_.is_two_d) force_two_d(measurement);
  measurement.control = state().control;
  const std::string source = measurement.source;
  if (estimator_.add(std::move(measurement))) return;
  RCLCPP_WARN_THROTTLE(get_logger(), *get_clock(), 5000,
                       "%s: %zu measurements wait for their time, which is in the future; the one "
                       "that is furthest ahead is dropped",
                       source.c_str(), Estimator::kMostEntries);
}

std::optional<Eigen::Isometry3d> FilterNode::find_frame(const std::string& part,
                                                        const std::string& target,
                                                        const std::string& source,
                                                        const rclcpp::Time& time) {
  auto transform = transforms_.lookup(target, source, time, parameters_.transform_timeout);
  if (!transform) {
    report_.warn(part + "_transform",
                 "Could not obtain transform from " + source + " to " + target + ".");
  }
  return transform;
}

/// The identity for zeros, which some drivers send; NaN for what has no direction otherwise, which
/// is skipped later like every value that is not finite.
Eigen::Matrix3d FilterNode::checked_rotation(const Part& part,
                                             const geometry_msgs::msg::Quaternion& message) {
  const auto rotation = rotation_of(message);
  const double length =
      std::hypot(std::hypot(message.x, message.y), std::hypot(message.z, message.w));
  if (rotation && std::abs(length - 1.0) > 0.01) {
    RCLCPP_WARN_ONCE(get_logger(),
                     "An input was not normalized, this should NOT happen, but will normalize.");
  } else if (!rotation && (part.update & three_from(kRoll)).any()) {
    report_.warn(part.name + "_orientation",
                 "The " + part.name +
                     " message contains an invalid orientation quaternion, but its configuration "
                     "is such that orientation data is being used. " +
                     (length == 0.0 ? "Correcting..." : "Skipping it..."));
  }
  if (rotation) return rotation->toRotationMatrix();
  if (length == 0.0) return Eigen::Matrix3d::Identity();
  return Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
}

void FilterNode::on_odometry(Input& input, const nav_msgs::msg::Odometry& message) {
  if (input.pose.update.any()) {
    PoseMessage pose;
    pose.header = message.header;
    pose.pose = message.pose;
    on_pose(
        input, input.pose, pose,
        {parameters_.world_frame,
         input.settings.is_pose_of_child ? message.child_frame_id : parameters_.base_link_frame});
  }
  if (input.twist.update.any()) {
    geometry_msgs::msg::TwistWithCovarianceStamped twist;
    twist.header = message.header;
    twist.header.frame_id = message.child_frame_id;
    twist.twist = message.twist;
    on_twist(input.twist, twist);
  }
}

void FilterNode::on_imu(Input& input, const Imu& message) {
  if (input.pose.update.any() && !is_missing(message.orientation_covariance)) {
    PoseMessage pose;
    pose.header = message.header;
    pose.pose.pose.orientation = message.orientation;
    copy_angular(message.orientation_covariance, pose.pose.covariance);
    const std::string& base = parameters_.base_link_frame;
    on_pose(input, input.pose, pose, {base, base, true});
  }
  if (input.twist.update.any() && !is_missing(message.angular_velocity_covariance)) {
    geometry_msgs::msg::TwistWithCovarianceStamped twist;
    twist.header = message.header;
    twist.twist.twist.angular = message.angular_velocity;
    copy_angular(message.angular_velocity_covariance, twist.twist.covariance);
    on_twist(input.twist, twist);
  }
  if (input.acceleration.update.any() && !is_missing(message.linear_acceleration_covariance)) {
    on_acceleration(input, message);
  }
}

void FilterNode::on_pose(Input& input, Part& part, const PoseMessage& message,
                         const PoseFrames& frames) {
  auto measurement = begin(part, message.header.stamp);
  if (!measurement) return;
  PoseReading reading;
  reading.is_imu = frames.is_imu;
  reading.is_differential = input.settings.is_differential;
  reading.is_relative = input.settings.is_relative;
  reading.pose.translation() = vector_of(message.pose.pose.position);
  reading.pose.linear() = checked_rotation(part, message.pose.pose.orientation);
  reading.covariance = Matrix6::Map(message.pose.covariance.data());
  // A difference is the same in every fixed frame.
  const bool needs_no_frame = reading.is_differential && !frames.is_imu;
  const std::string& source = needs_no_frame ? frames.target : message.header.frame_id;
  const auto transform = find_frame(part.name, frames.target, source, message.header.stamp);
  if (!transform) return;
  reading.target_from_message = *transform;
  if (frames.child != parameters_.base_link_frame) {
    reading.child_from_base =
        find_frame(part.name, frames.child, parameters_.base_link_frame, message.header.stamp);
  }
  report_.check_covariance(part.name, reading.covariance, kX, part.update);
  if (part.poses.take(reading, turning_, *measurement)) enqueue(std::move(*measurement));
}

void FilterNode::on_twist(Part& part,
                          const geometry_msgs::msg::TwistWithCovarianceStamped& message) {
  auto measurement = begin(part, message.header.stamp);
  if (!measurement) return;
  const std::string& base = parameters_.base_link_frame;
  const std::string& frame = message.header.frame_id.empty() ? base : message.header.frame_id;
  const auto transform = find_frame(part.name, base, frame, message.header.stamp);
  if (!transform) return;
  TwistReading reading;
  reading.linear = vector_of(message.twist.twist.linear);
  reading.angular = vector_of(message.twist.twist.angular);
  reading.covariance = Matrix6::Map(message.twist.covariance.data());
  reading.base_from_sensor = *transform;
  report_.check_covariance(part.name, reading.covariance, kVx, part.update);
  take_twist(reading, turning_, *measurement);
  enqueue(std::move(*measurement));
}

void FilterNode::on_acceleration(Input& input, const Imu& message) {
  auto measurement = begin(input.acceleration, message.header.stamp);
  if (!measurement) return;
  const std::string& base = parameters_.base_link_frame;
  const std::string& frame = message.header.frame_id.empty() ? base : message.header.frame_id;
  const auto transform = find_frame(input.acceleration.name, base, frame, message.header.stamp);
  if (!transform) return;
  AccelerationReading reading;
  reading.acceleration = vector_of(message.linear_acceleration);
  reading.covariance = Eigen::Matrix3d::Map(message.linear_acceleration_covariance.data());
  reading.base_from_sensor = *transform;
  if (input.settings.removes_gravity) {
    reading.gravity = gravity_of(input, message, transform->linear());
  }
  report_.check_covariance(input.acceleration.name, reading.covariance, kAx,
                           input.acceleration.update);
  take_acceleration(reading, turning_, *measurement);
  enqueue(std::move(*measurement));
}

/// In the frame of the sensor, by its own orientation when it has one, else by the estimate.
Eigen::Vector3d FilterNode::gravity_of(const Input& input, const Imu& message,
                                       const Eigen::Matrix3d& base_from_sensor) const {
  const auto own = rotation_of(message.orientation);
  Eigen::Matrix3d world_from_sensor;
  if (is_missing(message.orientation_covariance) || !own) {
    const State& mean = state().mean;
    world_from_sensor =
        quaternion_of(mean(kRoll), mean(kPitch), mean(kYaw)).toRotationMatrix() * base_from_sensor;
  } else if (input.settings.is_relative) {
    // It counts from a level robot, not from a level sensor.
    world_from_sensor = base_from_sensor * own->toRotationMatrix();
  } else {
    world_from_sensor = own->toRotationMatrix();
  }
  return gravity_in(world_from_sensor, parameters_.gravity);
}

}  // namespace robot_localization
