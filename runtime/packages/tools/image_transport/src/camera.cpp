// Images with what is known of the camera.
#include <chrono>
#include <utility>

#include "image_transport/camera_common.hpp"
#include "image_transport/camera_publisher.hpp"
#include "image_transport/camera_subscriber.hpp"
#include "image_transport/subscriber_filter.hpp"
#include "message_filters/subscriber.h"
#include "message_filters/time_synchronizer.h"
#include "rclcpp/rclcpp.hpp"

namespace image_transport {
namespace {

/// The image's topic before remapping, so that each topic is remapped by its own name.
std::string expanded(rclcpp::Node* node, const std::string& base_topic) {
  return node->get_node_topics_interface()->resolve_topic_name(base_topic, true);
}

rclcpp::Logger logger() {
  return rclcpp::get_logger("image_transport");
}

}  // namespace

std::string getCameraInfoTopic(const std::string& base_topic) {
  return base_topic.substr(0, base_topic.rfind('/') + 1) + "camera_info";
}

std::string erase_last_copy(const std::string& input, const std::string& search) {
  const size_t at = input.rfind(search);
  return at == std::string::npos ? input : std::string(input).erase(at, search.size());
}

// --- CameraPublisher ----------------------------------------------------------------------------

CameraPublisher::CameraPublisher(rclcpp::Node* node, const std::string& base_topic,
                                 rmw_qos_profile_t custom_qos, rclcpp::PublisherOptions options) {
  const std::string topic = expanded(node, base_topic);
  image_ = Publisher(node, topic, custom_qos, options);
  const rclcpp::QoS qos(rclcpp::QoSInitialization::from_rmw(custom_qos), custom_qos);
  info_ = std::make_shared<InfoPublisher::SharedPtr>(
      node->create_publisher<sensor_msgs::msg::CameraInfo>(getCameraInfoTopic(topic), qos,
                                                           std::move(options)));
}

size_t CameraPublisher::getNumSubscribers() const {
  return *this ? std::max(image_.getNumSubscribers(), (*info_)->get_subscription_count()) : 0;
}

std::string CameraPublisher::getTopic() const {
  return image_.getTopic();
}

std::string CameraPublisher::getInfoTopic() const {
  return *this ? (*info_)->get_topic_name() : "";
}

void CameraPublisher::publish(const sensor_msgs::msg::Image& image,
                              const sensor_msgs::msg::CameraInfo& info) const {
  if (!*this) {
    RCLCPP_FATAL(logger(), "Call to publish() on an invalid image_transport::CameraPublisher");
    return;
  }
  image_.publish(image);
  (*info_)->publish(info);
}

void CameraPublisher::publish(const sensor_msgs::msg::Image::ConstSharedPtr& image,
                              const sensor_msgs::msg::CameraInfo::ConstSharedPtr& info) const {
  publish(*image, *info);
}

void CameraPublisher::publish(sensor_msgs::msg::Image::UniquePtr image,
                              sensor_msgs::msg::CameraInfo::UniquePtr info) const {
  publish(*image, *info);
}

void CameraPublisher::publish(sensor_msgs::msg::Image& image, sensor_msgs::msg::CameraInfo& info,
                              rclcpp::Time stamp) const {
  image.header.stamp = stamp;
  info.header.stamp = stamp;
  publish(std::as_const(image), std::as_const(info));
}

void CameraPublisher::shutdown() {
  image_.shutdown();
  if (info_ != nullptr) {
    info_->reset();
  }
}

// --- CameraSubscriber ---------------------------------------------------------------------------

struct CameraSubscriber::Impl {
  using Image = sensor_msgs::msg::Image;
  using CameraInfo = sensor_msgs::msg::CameraInfo;

  /// Since the last look: it warns of topics that do not belong together.
  int images = 0;
  int infos = 0;
  int both = 0;

  SubscriberFilter image;
  message_filters::Subscriber<CameraInfo> info;
  message_filters::TimeSynchronizer<Image, CameraInfo> synchronizer{10};
  rclcpp::TimerBase::SharedPtr check;
  rclcpp::Logger log = logger();

  void look() {
    const int limit = 3 * both;
    if (images > limit || infos > limit) {
      RCLCPP_WARN(log,
                  "Topics '%s' and '%s' do not appear to be synchronized. In the last 10s:\n"
                  "\tImage messages received:      %d\n"
                  "\tCameraInfo messages received: %d\n"
                  "\tSynchronized pairs:           %d",
                  image.getTopic().c_str(), info.getTopic().c_str(), images, infos, both);
    }
    images = infos = both = 0;
  }
};

CameraSubscriber::CameraSubscriber(rclcpp::Node* node, const std::string& base_topic,
                                   const Callback& callback, const std::string& transport,
                                   rmw_qos_profile_t custom_qos)
    : impl_(std::make_shared<Impl>()) {
  const std::string topic = expanded(node, base_topic);
  Impl* impl = impl_.get();
  impl->log = node->get_logger();
  impl->synchronizer.connectInput(impl->image, impl->info);
  impl->synchronizer.registerCallback(std::function<void(const Impl::Image::ConstSharedPtr&,
                                                         const Impl::CameraInfo::ConstSharedPtr&)>(
      [impl, callback](const Impl::Image::ConstSharedPtr& image,
                       const Impl::CameraInfo::ConstSharedPtr& info) {
        ++impl->both;
        callback(image, info);
      }));
  impl->image.registerCallback([impl](const Impl::Image::ConstSharedPtr&) { ++impl->images; });
  impl->info.registerCallback([impl](const Impl::CameraInfo::ConstSharedPtr&) { ++impl->infos; });
  impl->image.subscribe(node, topic, transport, custom_qos);
  impl->info.subscribe(node, getCameraInfoTopic(topic), custom_qos);
  impl->check = node->create_wall_timer(std::chrono::seconds(10), [impl] { impl->look(); });
}

CameraSubscriber::operator void*() const {
  return impl_ != nullptr && impl_->image.getSubscriber() ? impl_.get() : nullptr;
}

std::string CameraSubscriber::getTopic() const {
  return *this ? impl_->image.getTopic() : "";
}

std::string CameraSubscriber::getInfoTopic() const {
  return *this ? impl_->info.getSubscriber()->get_topic_name() : "";
}

size_t CameraSubscriber::getNumPublishers() const {
  return *this ? std::max(impl_->image.getNumPublishers(),
                          impl_->info.getSubscriber()->get_publisher_count())
               : 0;
}

std::string CameraSubscriber::getTransport() const {
  return *this ? impl_->image.getTransport() : "";
}

void CameraSubscriber::shutdown() {
  if (impl_ != nullptr) {
    impl_->check->cancel();
    impl_->image.unsubscribe();
    impl_->info.unsubscribe();
  }
}

}  // namespace image_transport
