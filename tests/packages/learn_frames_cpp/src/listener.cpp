#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "geometry_msgs/msg/point_stamped.hpp"
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2/exceptions.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "tf2_ros/buffer.h"
#include "tf2_ros/transform_listener.h"

using namespace std::chrono_literals;

class FrameListener : public rclcpp::Node
{
public:
  FrameListener()
  : Node("frame_listener")
  {
    tf_buffer_ = std::make_unique<tf2_ros::Buffer>(this->get_clock());
    tf_listener_ = std::make_shared<tf2_ros::TransformListener>(*tf_buffer_);
    timer_ = this->create_wall_timer(100ms, std::bind(&FrameListener::on_timer, this));
  }

private:
  void on_timer()
  {
    geometry_msgs::msg::TransformStamped t;
    try {
      t = tf_buffer_->lookupTransform("world", "cup", tf2::TimePointZero);
    } catch (const tf2::TransformException & ex) {
      RCLCPP_INFO_ONCE(this->get_logger(), "Could not transform: %s", ex.what());
      return;
    }
    RCLCPP_INFO(
      this->get_logger(), "the cup is at %.1f %.1f %.1f", t.transform.translation.x, t.transform.translation.y,
      t.transform.translation.z);
    geometry_msgs::msg::PointStamped point;
    point.header.frame_id = "cup";
    point.point.x = 1.0;
    auto seen = tf_buffer_->transform(point, "world", tf2::durationFromSec(1.0));
    RCLCPP_INFO(this->get_logger(), "its handle is at %.1f %.1f", seen.point.x, seen.point.y);
    try {
      tf_buffer_->lookupTransform("world", "plate", tf2::TimePointZero);
    } catch (const tf2::LookupException & ex) {
      RCLCPP_INFO(this->get_logger(), "no plate: %s", ex.what());
    }
    rclcpp::shutdown();
  }

  std::unique_ptr<tf2_ros::Buffer> tf_buffer_;
  std::shared_ptr<tf2_ros::TransformListener> tf_listener_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<FrameListener>());
  rclcpp::shutdown();
  return 0;
}
