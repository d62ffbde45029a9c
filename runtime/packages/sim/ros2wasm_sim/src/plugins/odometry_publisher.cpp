// OdometryPublisher of Gazebo Sim: the true pose of a model.
#include <nav_msgs/msg/odometry.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include <cmath>
#include <deque>

#include "plugins/gz_topics.hpp"
#include "plugins/messages.hpp"
#include "sensors/noise.hpp"

namespace ros2wasm_sim {
namespace {

/// The mean of the last ten steps.
class RollingMean {
 public:
  void push(const Vector3& v) {
    values_.push_back(v);
    if (values_.size() > 10) values_.pop_front();
  }
  Vector3 mean() const {
    Vector3 sum;
    for (const Vector3& one : values_) sum = sum + one;
    return values_.empty() ? sum : 1.0 / static_cast<double>(values_.size()) * sum;
  }

 private:
  std::deque<Vector3> values_;
};

class OdometryPublisher final : public System {
 public:
  explicit OdometryPublisher(const PluginContext& context)
      : simulation_(context.simulation),
        model_(context.model->name),
        random_(context.host.seed(), model_ + "::OdometryPublisher"),
        rate_(Parameters(context.plugin.xml).number("odom_publish_frequency", 50)) {
    const Parameters given(context.plugin.xml);
    frame_ = given.text("odom_frame", model_ + "/odom");
    base_frame_ = given.text("robot_base_frame", model_ + "/base_footprint");
    is_flat_ = given.number("dimensions", 2) != 3;
    const Vector3 turn = given.vector("rpy_offset");
    offset_ = {given.vector("xyz_offset"), from_roll_pitch_yaw(turn.x, turn.y, turn.z)};
    noise_ = given.number("gaussian_noise", 0);
    const std::string prefix = "/model/" + model_;
    const std::string topic = topic_of(given, "odom_topic", prefix + "/odometry");
    odometry_ = publish_gz<nav_msgs::msg::Odometry>(context.host, topic);
    covariance_ = publish_gz<nav_msgs::msg::Odometry>(
        context.host,
        topic_of(given, "odom_covariance_topic", prefix + "/odometry_with_covariance"));
    frames_ = publish_gz<tf2_msgs::msg::TFMessage>(context.host,
                                                   topic_of(given, "tf_topic", prefix + "/pose"));
  }

  void after_step(const Now& now) override {
    const Model* model = simulation_.model(model_);
    if (model == nullptr) return;
    const Pose pose = simulation_.model_pose(*model) * offset_;
    if (began_) measure(pose, now.step);
    began_ = true;
    last_ = pose;
    if (rate_.due(now.time_ns)) publish(pose, now);
  }

  void on_reset() override {
    rate_.reset();
    began_ = false;
  }

 private:
  void measure(const Pose& pose, double seconds) {
    const Vector3 moved = 1.0 / seconds * (pose.position - last_.position);
    const Quaternion change = inverse(last_.orientation) * pose.orientation;
    const double sign = change.w < 0 ? -2 : 2;
    const Vector3 turned = sign / seconds * Vector3{change.x, change.y, change.z};
    const Quaternion back =
        is_flat_ ? from_roll_pitch_yaw(0, 0, -yaw_of(pose.orientation)) : inverse(pose.orientation);
    linear_.push(rotate(back, moved));
    angular_.push(turned);
  }

  void publish(const Pose& pose, const Now& now) {
    nav_msgs::msg::Odometry message;
    message.header.stamp = stamp_of(now.time_ns);
    message.header.frame_id = frame_;
    message.child_frame_id = base_frame_;
    Pose shown = pose;
    if (is_flat_)
      shown = {{pose.position.x, pose.position.y, 0},
               from_roll_pitch_yaw(0, 0, yaw_of(pose.orientation))};
    message.pose.pose = pose_message(shown);
    const auto noisy = [&](double value) {
      return noise_ > 0 ? value + noise_ * random_.gaussian() : value;
    };
    const Vector3 linear = linear_.mean(), angular = angular_.mean();
    auto& twist = message.twist.twist;
    twist.linear.x = noisy(linear.x);
    twist.linear.y = noisy(linear.y);
    twist.angular.z = noisy(angular.z);
    if (!is_flat_) {
      twist.linear.z = noisy(linear.z);
      twist.angular.x = noisy(angular.x);
      twist.angular.y = noisy(angular.y);
    }
    odometry_->publish(message);
    for (std::size_t i = 0; i < 6; ++i)
      message.pose.covariance[7 * i] = message.twist.covariance[7 * i] = noise_ * noise_;
    covariance_->publish(message);
    tf2_msgs::msg::TFMessage frames;
    frames.transforms.push_back(
        transform_message(message.header.stamp, frame_, base_frame_, shown));
    frames_->publish(frames);
  }

  Simulation& simulation_;
  std::string model_;
  Random random_;
  Rate rate_;
  std::string frame_, base_frame_;
  bool is_flat_ = true;
  Pose offset_, last_;
  bool began_ = false;
  double noise_ = 0;
  RollingMean linear_, angular_;
  rclcpp::Publisher<nav_msgs::msg::Odometry>::SharedPtr odometry_, covariance_;
  rclcpp::Publisher<tf2_msgs::msg::TFMessage>::SharedPtr frames_;
};

}  // namespace

std::unique_ptr<System> make_odometry_publisher(const PluginContext& context) {
  return std::make_unique<OdometryPublisher>(context);
}

}  // namespace ros2wasm_sim
