// Publishes the frame `base_footprint`: that of `base_link` on the ground, upright.
#include <memory>
#include <string>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2/utils.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "tf2_msgs/msg/tf_message.hpp"
#include "tf2_ros/transform_broadcaster.h"

namespace {

class BaseFootprintPublisher : public rclcpp::Node {
 public:
  BaseFootprintPublisher() : Node("base_footprint_publisher"), broadcaster_(*this) {
    RCLCPP_INFO(get_logger(), "Creating base footprint publisher");
    base_link_ = declare_parameter("base_link_frame", "base_link");
    base_footprint_ = declare_parameter("base_footprint_frame", "base_footprint");
    constexpr size_t kDepth = 100;
    subscription_ = create_subscription<tf2_msgs::msg::TFMessage>(
        "/tf", rclcpp::QoS(kDepth), [this](const tf2_msgs::msg::TFMessage& message) {
          for (const auto& transform : message.transforms) {
            if (transform.child_frame_id != base_link_) continue;
            broadcaster_.sendTransform(footprint_of(transform));
            return;
          }
        });
  }

 private:
  geometry_msgs::msg::TransformStamped footprint_of(
      const geometry_msgs::msg::TransformStamped& base) const {
    geometry_msgs::msg::TransformStamped footprint;
    footprint.header.stamp = base.header.stamp;
    footprint.header.frame_id = base_link_;
    footprint.child_frame_id = base_footprint_;
    footprint.transform.translation = base.transform.translation;
    footprint.transform.translation.z = 0.0;
    tf2::Quaternion upright;
    upright.setRPY(0, 0, tf2::getYaw(base.transform.rotation));
    footprint.transform.rotation = tf2::toMsg(upright);
    return footprint;
  }

  tf2_ros::TransformBroadcaster broadcaster_;
  std::string base_link_;
  std::string base_footprint_;
  rclcpp::Subscription<tf2_msgs::msg::TFMessage>::SharedPtr subscription_;
};

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<BaseFootprintPublisher>());
  rclcpp::shutdown();
  return 0;
}
