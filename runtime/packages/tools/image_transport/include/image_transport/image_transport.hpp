// Publishers of and subscribers to images. There is one transport, raw: messages as they are.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "image_transport/camera_publisher.hpp"
#include "image_transport/camera_subscriber.hpp"
#include "image_transport/exception.hpp"
#include "image_transport/publisher.hpp"
#include "image_transport/subscriber.hpp"
#include "image_transport/transport_hints.hpp"
#include "image_transport/visibility_control.hpp"
#include "rclcpp/node.hpp"

namespace image_transport {

Publisher create_publisher(rclcpp::Node* node, const std::string& base_topic,
                           rmw_qos_profile_t custom_qos = rmw_qos_profile_default,
                           rclcpp::PublisherOptions options = rclcpp::PublisherOptions());
Subscriber create_subscription(rclcpp::Node* node, const std::string& base_topic,
                               const Subscriber::Callback& callback, const std::string& transport,
                               rmw_qos_profile_t custom_qos = rmw_qos_profile_default,
                               rclcpp::SubscriptionOptions options = rclcpp::SubscriptionOptions());
CameraPublisher create_camera_publisher(
    rclcpp::Node* node, const std::string& base_topic,
    rmw_qos_profile_t custom_qos = rmw_qos_profile_default,
    rclcpp::PublisherOptions pub_options = rclcpp::PublisherOptions());
CameraSubscriber create_camera_subscription(rclcpp::Node* node, const std::string& base_topic,
                                            const CameraSubscriber::Callback& callback,
                                            const std::string& transport,
                                            rmw_qos_profile_t custom_qos = rmw_qos_profile_default);

std::vector<std::string> getDeclaredTransports();
std::vector<std::string> getLoadableTransports();

/// How many messages a topic keeps, or its whole quality of service.
struct QueueQoS {
  QueueQoS(uint32_t queue_size) : profile(rmw_qos_profile_default) { profile.depth = queue_size; }
  QueueQoS(const rmw_qos_profile_t& custom_qos) : profile(custom_qos) {}

  rmw_qos_profile_t profile;
};

/// All of it for one node. Where `qos` stands, a number or an rmw_qos_profile_t is given.
class ImageTransport {
 public:
  using VoidPtr = std::shared_ptr<void>;
  using ImageConstPtr = sensor_msgs::msg::Image::ConstSharedPtr;
  using CameraInfoConstPtr = sensor_msgs::msg::CameraInfo::ConstSharedPtr;

  explicit ImageTransport(rclcpp::Node::SharedPtr node) : node_(std::move(node)) {}

  /// With `latch`, those who come later get the last image.
  Publisher advertise(const std::string& base_topic, const QueueQoS& qos, bool latch = false);

  /// The tracked object lives as long as the callback.
  Subscriber subscribe(const std::string& base_topic, const QueueQoS& qos,
                       const Subscriber::Callback& callback,
                       const VoidPtr& tracked_object = VoidPtr(),
                       const TransportHints* transport_hints = nullptr,
                       const rclcpp::SubscriptionOptions options = rclcpp::SubscriptionOptions());
  Subscriber subscribe(const std::string& base_topic, const QueueQoS& qos,
                       void (*fp)(const ImageConstPtr&),
                       const TransportHints* transport_hints = nullptr,
                       const rclcpp::SubscriptionOptions options = rclcpp::SubscriptionOptions()) {
    return subscribe(base_topic, qos, Subscriber::Callback(fp), VoidPtr(), transport_hints,
                     options);
  }
  template <class T>
  Subscriber subscribe(const std::string& base_topic, const QueueQoS& qos,
                       void (T::*fp)(const ImageConstPtr&), T* obj,
                       const TransportHints* transport_hints = nullptr,
                       const rclcpp::SubscriptionOptions options = rclcpp::SubscriptionOptions()) {
    return subscribe(
        base_topic, qos, [fp, obj](const ImageConstPtr& image) { (obj->*fp)(image); }, VoidPtr(),
        transport_hints, options);
  }
  template <class T>
  Subscriber subscribe(const std::string& base_topic, const QueueQoS& qos,
                       void (T::*fp)(const ImageConstPtr&), const std::shared_ptr<T>& obj,
                       const TransportHints* transport_hints = nullptr,
                       const rclcpp::SubscriptionOptions options = rclcpp::SubscriptionOptions()) {
    return subscribe(
        base_topic, qos,
        [fp, object = obj.get()](const ImageConstPtr& image) { (object->*fp)(image); }, obj,
        transport_hints, options);
  }

  CameraPublisher advertiseCamera(const std::string& base_topic, const QueueQoS& qos,
                                  bool latch = false);

  CameraSubscriber subscribeCamera(const std::string& base_topic, const QueueQoS& qos,
                                   const CameraSubscriber::Callback& callback,
                                   const VoidPtr& tracked_object = VoidPtr(),
                                   const TransportHints* transport_hints = nullptr);
  CameraSubscriber subscribeCamera(const std::string& base_topic, const QueueQoS& qos,
                                   void (*fp)(const ImageConstPtr&, const CameraInfoConstPtr&),
                                   const TransportHints* transport_hints = nullptr) {
    return subscribeCamera(base_topic, qos, CameraSubscriber::Callback(fp), VoidPtr(),
                           transport_hints);
  }
  template <class T>
  CameraSubscriber subscribeCamera(const std::string& base_topic, const QueueQoS& qos,
                                   void (T::*fp)(const ImageConstPtr&, const CameraInfoConstPtr&),
                                   T* obj, const TransportHints* transport_hints = nullptr) {
    return subscribeCamera(
        base_topic, qos,
        [fp, obj](const ImageConstPtr& image, const CameraInfoConstPtr& info) {
          (obj->*fp)(image, info);
        },
        VoidPtr(), transport_hints);
  }
  template <class T>
  CameraSubscriber subscribeCamera(const std::string& base_topic, const QueueQoS& qos,
                                   void (T::*fp)(const ImageConstPtr&, const CameraInfoConstPtr&),
                                   const std::shared_ptr<T>& obj,
                                   const TransportHints* transport_hints = nullptr) {
    return subscribeCamera(
        base_topic, qos,
        [fp, object = obj.get()](const ImageConstPtr& image, const CameraInfoConstPtr& info) {
          (object->*fp)(image, info);
        },
        obj, transport_hints);
  }

  std::vector<std::string> getDeclaredTransports() const;
  std::vector<std::string> getLoadableTransports() const;

 private:
  std::string transport_of(const TransportHints* transport_hints) const;

  rclcpp::Node::SharedPtr node_;
};

}  // namespace image_transport
