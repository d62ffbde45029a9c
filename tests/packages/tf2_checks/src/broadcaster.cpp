// As the tutorials on broadcasters have it: one frame that moves, one that does not.

// Compatibility, works: tf2_ros: broadcasters, a listener that needs no executor of the user's,
// lookups that wait, also in a callback and on a page without threads; tf2_geometry_msgs

#include <cmath>

#include "checks.hpp"
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2/LinearMath/Quaternion.h"
#include "tf2_ros/static_transform_broadcaster.h"
#include "tf2_ros/transform_broadcaster.h"

using std::chrono_literals::operator""ms;

class FramePublisher : public rclcpp::Node {
 public:
  explicit FramePublisher(Checks& shared)
      : Node("frame_publisher"), checks(shared), moving_(*this), fixed_(this) {
    geometry_msgs::msg::TransformStamped mount;
    mount.header.stamp = get_clock()->now();
    mount.header.frame_id = "turtle1";
    mount.child_frame_id = "camera";
    mount.transform.translation.z = 0.5;
    mount.transform.rotation.w = 1.0;
    fixed_.sendTransform(mount);
    timer_ = create_wall_timer(20ms, [this] { move(); });
  }

 private:
  void move() {
    const bool heard = count_subscribers("/tf") > 0;
    if (was_heard_ && !heard) {
      CHECK(count_publishers("/tf_static") == 1);
      rclcpp::shutdown();
    }
    was_heard_ = heard;
    geometry_msgs::msg::TransformStamped turtle;
    turtle.header.stamp = get_clock()->now();
    turtle.header.frame_id = "world";
    turtle.child_frame_id = "turtle1";
    // On the unit circle, looking outwards.
    const double angle = now().seconds();
    turtle.transform.translation.x = std::cos(angle);
    turtle.transform.translation.y = std::sin(angle);
    tf2::Quaternion q;
    q.setRPY(0, 0, angle);
    turtle.transform.rotation.x = q.x();
    turtle.transform.rotation.y = q.y();
    turtle.transform.rotation.z = q.z();
    turtle.transform.rotation.w = q.w();
    moving_.sendTransform(turtle);
  }

  Checks& checks;
  bool was_heard_ = false;
  tf2_ros::TransformBroadcaster moving_;
  tf2_ros::StaticTransformBroadcaster fixed_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("broadcaster");
  rclcpp::spin(std::make_shared<FramePublisher>(checks));
  return checks.finish();
}
