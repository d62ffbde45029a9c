// As the tutorials have it: subscriptions that are put together, and messages that wait until they
// can be transformed.

// Compatibility, works: message_filters with all its policies, callbacks in every form;
// `tf2_ros::MessageFilter`

#include <cmath>
#include <memory>

#include "checks.hpp"
#include "geometry_msgs/msg/point_stamped.hpp"
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "message_filters/subscriber.hpp"
#include "message_filters/synchronizer.hpp"
#include "message_filters/time_synchronizer.hpp"
#include "tf2_ros/buffer.h"
#include "tf2_ros/create_timer_ros.h"
#include "tf2_ros/message_filter.h"
#include "tf2_ros/static_transform_broadcaster.h"
#include "tf2_ros/transform_listener.h"

using geometry_msgs::msg::PointStamped;
using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;
using std::placeholders::_1;
using std::placeholders::_2;

class Sensors : public rclcpp::Node {
 public:
  Sensors() : Node("sensors"), broadcaster_(this) {
    left_ = create_publisher<PointStamped>("left", 10);
    right_ = create_publisher<PointStamped>("right", 10);
    timer_ = create_wall_timer(10ms, [this] { tell(); });
  }
  void mount() {
    geometry_msgs::msg::TransformStamped mount;
    mount.header.stamp = now();
    mount.header.frame_id = "world";
    mount.child_frame_id = "camera";
    mount.transform.translation.z = 2;
    mount.transform.rotation.w = 1;
    broadcaster_.sendTransform(mount);
  }

 private:
  void tell() {
    PointStamped message;
    message.header.stamp = now();
    message.header.frame_id = "camera";
    message.point.x = ++count_;
    left_->publish(message);
    message.point.x = -count_;
    right_->publish(message);
  }

  rclcpp::Publisher<PointStamped>::SharedPtr left_;
  rclcpp::Publisher<PointStamped>::SharedPtr right_;
  rclcpp::TimerBase::SharedPtr timer_;
  tf2_ros::StaticTransformBroadcaster broadcaster_;
  int count_ = 0;
};

class Eyes : public rclcpp::Node {
 public:
  Eyes(Checks& shared, std::function<void()> mount)
      : Node("eyes"), checks(shared), mount_(std::move(mount)) {
    left_.subscribe(this, "left");
    right_.subscribe(this, "right", rmw_qos_profile_sensor_data);
    sync_ = std::make_shared<message_filters::TimeSynchronizer<PointStamped, PointStamped>>(
        left_, right_, 10);
    sync_->registerCallback(std::bind(&Eyes::see, this, _1, _2));

    buffer_ = std::make_shared<tf2_ros::Buffer>(get_clock());
    buffer_->setCreateTimerInterface(std::make_shared<tf2_ros::CreateTimerROS>(
        get_node_base_interface(), get_node_timers_interface()));
    listener_ = std::make_shared<tf2_ros::TransformListener>(*buffer_);
    filter_ = std::make_shared<tf2_ros::MessageFilter<PointStamped>>(
        left_, *buffer_, "world", 100, get_node_logging_interface(), get_node_clock_interface(),
        std::chrono::duration<int>(10));
    filter_->registerCallback(&Eyes::locate, this);
    impatient_ = std::make_shared<tf2_ros::MessageFilter<PointStamped>>(
        *buffer_, "nowhere", 1, get_node_logging_interface(), get_node_clock_interface());
    impatient_->registerCallback([this](const PointStamped&) { CHECK(false); });
  }

 private:
  void see(const PointStamped::ConstSharedPtr& left, const PointStamped::ConstSharedPtr& right) {
    CHECK(left->point.x == -right->point.x);
    CHECK(left->header.stamp == right->header.stamp);
    if (++seen_ == 3) {
      CHECK(located_ == 0);
      CHECK(left_.getTopic() == "left");
      mount_();
    }
  }

  void locate(const PointStamped::ConstSharedPtr& point) {
    const auto found = buffer_->lookupTransform("world", point->header.frame_id,
                                                tf2_ros::fromMsg(point->header.stamp));
    CHECK(found.transform.translation.z == 2);
    // Those that waited come first.
    CHECK(point->point.x == ++located_);
    if (located_ < 3) {
      return;
    }
    // The second pushes the first out; nothing is heard of either.
    impatient_->add(point);
    impatient_->add(point);
    impatient_->clear();
    left_.unsubscribe();
    CHECK(left_.getSubscriber() == nullptr);
    left_.subscribe();
    CHECK(left_.getSubscriber() != nullptr);
    rclcpp::shutdown();
  }

  Checks& checks;
  std::function<void()> mount_;
  message_filters::Subscriber<PointStamped> left_;
  message_filters::Subscriber<PointStamped> right_;
  std::shared_ptr<message_filters::TimeSynchronizer<PointStamped, PointStamped>> sync_;
  std::shared_ptr<tf2_ros::Buffer> buffer_;
  std::shared_ptr<tf2_ros::TransformListener> listener_;
  std::shared_ptr<tf2_ros::MessageFilter<PointStamped>> filter_;
  std::shared_ptr<tf2_ros::MessageFilter<PointStamped>> impatient_;
  int seen_ = 0;
  int located_ = 0;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("subscribers");
  rclcpp::executors::SingleThreadedExecutor executor;
  const auto sensors = std::make_shared<Sensors>();
  const auto eyes = std::make_shared<Eyes>(checks, [sensors] { sensors->mount(); });
  executor.add_node(eyes);
  executor.add_node(sensors);
  executor.spin();
  return checks.finish();
}
