// As the tutorials on listeners have it, against the program `broadcaster`. Every way to wait lets
// transforms in: a spinning executor, a lookup with a timeout in a callback, a plain rate.

// Compatibility, works: tf2_ros: broadcasters, a listener that needs no executor of the user's,
// lookups that wait, also in a callback and on a page without threads; tf2_geometry_msgs

// Compatibility, differs: `tf2_ros::TransformListener` with `spin_thread` -> no thread: transforms
// are taken in whenever the program waits (spin, a rate, a clock's sleep) or asks its buffer, so
// it runs on any page; a program that only computes or sleeps by `std::this_thread` keeps the last
// 100 messages of each topic

#include <Eigen/Geometry>  // by tf2_geometry_msgs, as natively
#include <cmath>
#include <memory>

#include "checks.hpp"
#include "geometry_msgs/msg/point_stamped.hpp"
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rclcpp/node_interfaces/get_node_base_interface.hpp"
#include "rclcpp/node_interfaces/get_node_timers_interface.hpp"
#include "tf2/exceptions.h"
#include "tf2/utils.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "tf2_ros/create_timer_ros.h"
#include "tf2_ros/transform_listener.h"  // older sources take the buffer from here

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

class FrameListener : public rclcpp::Node {
 public:
  explicit FrameListener(Checks& shared) : Node("frame_listener"), checks(shared) {
    tf_buffer_ = std::make_unique<tf2_ros::Buffer>(get_clock());
    tf_buffer_->setCreateTimerInterface(std::make_shared<tf2_ros::CreateTimerROS>(
        rclcpp::node_interfaces::get_node_base_interface(*this),
        rclcpp::node_interfaces::get_node_timers_interface(this)));
    tf_listener_ = std::make_shared<tf2_ros::TransformListener>(*tf_buffer_);
    timer_ = create_wall_timer(10ms, [this] { on_timer(); });
  }

 private:
  void on_timer() {
    geometry_msgs::msg::TransformStamped found;
    try {
      found = tf_buffer_->lookupTransform("world", "camera", tf2::TimePointZero);
    } catch (const tf2::TransformException&) {
      return;
    }
    timer_->cancel();
    CHECK(found.header.frame_id == "world");
    CHECK(found.child_frame_id == "camera");
    const auto& translation = found.transform.translation;
    CHECK(std::abs(std::hypot(translation.x, translation.y) - 1) < 1e-9);
    CHECK(std::abs(translation.z - 0.5) < 1e-9);
    // It looks outwards.
    const double yaw = tf2::getYaw(found.transform.rotation);
    CHECK(std::abs(std::remainder(yaw - std::atan2(translation.y, translation.x), 2 * M_PI)) <
          1e-9);

    // What is yet to come: the callback waits, and meanwhile it comes.
    const rclcpp::Time soon = now() + rclcpp::Duration(100ms);
    CHECK(!tf_buffer_->canTransform("world", "turtle1", soon));
    const auto later = tf_buffer_->lookupTransform("world", "turtle1", soon, 10s);
    CHECK(rclcpp::Time(later.header.stamp) == soon);
    CHECK_THROWS(
        tf2::ForwardExtrapolationException,
        tf_buffer_->lookupTransform("world", "turtle1", soon + rclcpp::Duration(60s), 1ms));
    CHECK_THROWS(tf2::LookupException, tf_buffer_->lookupTransform("world", "nowhere", soon, 1ms));

    geometry_msgs::msg::PointStamped ahead;
    ahead.header.frame_id = "turtle1";
    ahead.header.stamp = soon;
    ahead.point.x = 2;
    const auto in_world = tf_buffer_->transform(ahead, "world", 1s);
    CHECK(in_world.header.frame_id == "world");
    CHECK(std::abs(std::hypot(in_world.point.x, in_world.point.y) - 3) < 0.5);
    // In turtle1 it is where it was, whichever way round.
    const auto back = tf_buffer_->transform(in_world, "turtle1");
    CHECK(std::abs(back.point.x - 2) < 1e-9);

    const rclcpp::Time asked = now() + rclcpp::Duration(100ms);
    tf_buffer_->waitForTransform("world", "camera", tf2_ros::fromRclcpp(asked), 10s,
                                 [this, asked](const tf2_ros::TransformStampedFuture& future) {
                                   CHECK(rclcpp::Time(future.get().header.stamp) == asked);
                                   tf_buffer_->waitForTransform(
                                       "world", "nowhere", tf2::TimePointZero, 10ms,
                                       [this](const tf2_ros::TransformStampedFuture& none) {
                                         CHECK_THROWS(tf2::TimeoutException, none.get());
                                         rclcpp::shutdown();
                                       });
                                 });
  }

  Checks& checks;
  std::unique_ptr<tf2_ros::Buffer> tf_buffer_;
  std::shared_ptr<tf2_ros::TransformListener> tf_listener_;
  rclcpp::TimerBase::SharedPtr timer_;
};

// No executor at all: the frames come while the program sleeps.
void listen_without_spinning(Checks& checks) {
  auto node = rclcpp::Node::make_shared("sleeping_listener");
  tf2_ros::Buffer buffer(node->get_clock());
  tf2_ros::TransformListener listener(buffer, node);
  rclcpp::Rate rate(100);
  while (rclcpp::ok() && !buffer.canTransform("camera", "world", tf2::TimePointZero)) {
    rate.sleep();
  }
  CHECK(buffer.canTransform("world", "turtle1", tf2::TimePointZero, tf2::durationFromSec(1.0)));
  CHECK(buffer._frameExists("turtle1"));
}

// Without one that spins by itself, a lookup cannot wait.
void listen_with_the_node(Checks& checks) {
  auto node = rclcpp::Node::make_shared("spinning_listener");
  tf2_ros::Buffer buffer(node->get_clock());
  tf2_ros::TransformListener listener(buffer, node, false);
  std::string error;
  CHECK(!buffer.canTransform("world", "turtle1", tf2::TimePointZero, 1s, &error));
  CHECK(error == tf2_ros::threading_error);
  while (rclcpp::ok() && !buffer.canTransform("world", "turtle1", tf2::TimePointZero)) {
    rclcpp::spin_some(node);
    rclcpp::sleep_for(5ms);
  }
  CHECK(rclcpp::ok());
}

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("listener");
  // The broadcaster ends when nobody listens any more.
  const auto listener = std::make_shared<FrameListener>(checks);
  listen_without_spinning(checks);
  listen_with_the_node(checks);
  rclcpp::spin(listener);
  return checks.finish();
}
