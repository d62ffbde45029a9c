// Images and nothing else: publishers, subscribers, and how they are made.
#include "image_transport/image_transport.hpp"

#include <utility>

#include "image_transport/camera_common.hpp"
#include "rclcpp/logging.hpp"

namespace image_transport {
namespace {

const char* const kRaw = "raw";

rclcpp::QoS qos_of(const rmw_qos_profile_t& profile) {
  return rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(profile), profile);
}

rmw_qos_profile_t latched(rmw_qos_profile_t profile, bool latch) {
  if (latch) {
    profile.durability = RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL;
  }
  return profile;
}

}  // namespace

// --- Publisher ----------------------------------------------------------------------------------

Publisher::Publisher(rclcpp::Node* node, const std::string& base_topic,
                     rmw_qos_profile_t custom_qos, rclcpp::PublisherOptions options)
    : shared_(std::make_shared<ImagePublisher::SharedPtr>(
          node->create_publisher<sensor_msgs::msg::Image>(base_topic, qos_of(custom_qos),
                                                          std::move(options)))) {}

Publisher::operator void*() const {
  return shared_ == nullptr ? nullptr : shared_->get();
}

size_t Publisher::getNumSubscribers() const {
  return *this ? (*shared_)->get_subscription_count() : 0;
}

std::string Publisher::getTopic() const {
  return *this ? (*shared_)->get_topic_name() : "";
}

Publisher::ImagePublisher* Publisher::opened() const {
  if (!*this) {
    RCLCPP_FATAL(rclcpp::get_logger("image_transport"),
                 "Call to publish() on an invalid image_transport::Publisher");
    return nullptr;
  }
  return shared_->get();
}

void Publisher::publish(const sensor_msgs::msg::Image& message) const {
  if (ImagePublisher* publisher = opened()) {
    publisher->publish(message);
  }
}

void Publisher::publish(const sensor_msgs::msg::Image::ConstSharedPtr& message) const {
  publish(*message);
}

void Publisher::publish(sensor_msgs::msg::Image::UniquePtr message) const {
  if (ImagePublisher* publisher = opened()) {
    publisher->publish(std::move(message));
  }
}

void Publisher::shutdown() {
  if (shared_ != nullptr) {
    shared_->reset();
  }
}

// --- Subscriber ---------------------------------------------------------------------------------

Subscriber::Subscriber(rclcpp::Node* node, const std::string& base_topic, const Callback& callback,
                       const std::string& transport, rmw_qos_profile_t custom_qos,
                       rclcpp::SubscriptionOptions options) {
  if (transport != kRaw) {
    throw TransportLoadException(transport, "a site has the transport " + std::string(kRaw) +
                                                " only: image_transport/" + transport +
                                                "_sub is not there");
  }
  shared_ = std::make_shared<ImageSubscription::SharedPtr>(
      node->create_subscription<sensor_msgs::msg::Image>(base_topic, qos_of(custom_qos), callback,
                                                         std::move(options)));
}

Subscriber::operator void*() const {
  return shared_ == nullptr ? nullptr : shared_->get();
}

std::string Subscriber::getTopic() const {
  return *this ? (*shared_)->get_topic_name() : "";
}

size_t Subscriber::getNumPublishers() const {
  return *this ? (*shared_)->get_publisher_count() : 0;
}

std::string Subscriber::getTransport() const {
  return *this ? kRaw : "";
}

void Subscriber::shutdown() {
  if (shared_ != nullptr) {
    shared_->reset();
  }
}

// --- how they are made --------------------------------------------------------------------------

Publisher create_publisher(rclcpp::Node* node, const std::string& base_topic,
                           rmw_qos_profile_t custom_qos, rclcpp::PublisherOptions options) {
  return Publisher(node, base_topic, custom_qos, std::move(options));
}

Subscriber create_subscription(rclcpp::Node* node, const std::string& base_topic,
                               const Subscriber::Callback& callback, const std::string& transport,
                               rmw_qos_profile_t custom_qos, rclcpp::SubscriptionOptions options) {
  return Subscriber(node, base_topic, callback, transport, custom_qos, std::move(options));
}

CameraPublisher create_camera_publisher(rclcpp::Node* node, const std::string& base_topic,
                                        rmw_qos_profile_t custom_qos,
                                        rclcpp::PublisherOptions pub_options) {
  return CameraPublisher(node, base_topic, custom_qos, std::move(pub_options));
}

CameraSubscriber create_camera_subscription(rclcpp::Node* node, const std::string& base_topic,
                                            const CameraSubscriber::Callback& callback,
                                            const std::string& transport,
                                            rmw_qos_profile_t custom_qos) {
  return CameraSubscriber(node, base_topic, callback, transport, custom_qos);
}

std::vector<std::string> getDeclaredTransports() {
  return {std::string("image_transport/") + kRaw};
}

std::vector<std::string> getLoadableTransports() {
  return getDeclaredTransports();
}

// --- ImageTransport -----------------------------------------------------------------------------

Publisher ImageTransport::advertise(const std::string& base_topic, const QueueQoS& qos,
                                    bool latch) {
  return create_publisher(node_.get(), base_topic, latched(qos.profile, latch));
}

Subscriber ImageTransport::subscribe(const std::string& base_topic, const QueueQoS& qos,
                                     const Subscriber::Callback& callback,
                                     const VoidPtr& tracked_object,
                                     const TransportHints* transport_hints,
                                     const rclcpp::SubscriptionOptions options) {
  return create_subscription(
      node_.get(), base_topic,
      [callback, tracked_object](const ImageConstPtr& image) { callback(image); },
      transport_of(transport_hints), qos.profile, options);
}

CameraPublisher ImageTransport::advertiseCamera(const std::string& base_topic, const QueueQoS& qos,
                                                bool latch) {
  return create_camera_publisher(node_.get(), base_topic, latched(qos.profile, latch));
}

CameraSubscriber ImageTransport::subscribeCamera(const std::string& base_topic, const QueueQoS& qos,
                                                 const CameraSubscriber::Callback& callback,
                                                 const VoidPtr& tracked_object,
                                                 const TransportHints* transport_hints) {
  return create_camera_subscription(
      node_.get(), base_topic,
      [callback, tracked_object](const ImageConstPtr& image, const CameraInfoConstPtr& info) {
        callback(image, info);
      },
      transport_of(transport_hints), qos.profile);
}

std::vector<std::string> ImageTransport::getDeclaredTransports() const {
  return image_transport::getDeclaredTransports();
}

std::vector<std::string> ImageTransport::getLoadableTransports() const {
  return image_transport::getLoadableTransports();
}

std::string ImageTransport::transport_of(const TransportHints* transport_hints) const {
  return transport_hints == nullptr ? TransportHints(node_.get()).getTransport()
                                    : transport_hints->getTransport();
}

}  // namespace image_transport
