// A publisher of bytes whose type is known only by its name.
#pragma once

#include <memory>
#include <string>

#include "rclcpp/publisher_base.hpp"
#include "rclcpp/serialized_message.hpp"

namespace rclcpp {
namespace detail {

/// A type that is only a name: enough for bytes. Lives as long as its owner.
class NamedType {
 public:
  explicit NamedType(const std::string& name);
  NamedType(const NamedType&) = delete;
  NamedType& operator=(const NamedType&) = delete;
  const rosidl_message_type_support_t& type_support() const { return type_support_; }

 private:
  std::string name_;
  MessageCallbacks callbacks_;
  rosidl_message_type_support_t type_support_;
};

}  // namespace detail

class GenericPublisher : private detail::NamedType, public rclcpp::PublisherBase {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericPublisher)

  GenericPublisher(node_interfaces::NodeBaseInterface* node_base, const std::string& topic_name,
                   const std::string& topic_type, const rclcpp::QoS& qos,
                   const PublisherOptionsBase& options)
      : detail::NamedType(topic_type),
        rclcpp::PublisherBase(node_base, topic_name, type_support(), qos, options) {}

  void publish(const rclcpp::SerializedMessage& message) {
    const rcl_serialized_message_t& bytes = message.get_rcl_serialized_message();
    publish_bytes(bytes.buffer, bytes.buffer_length);
  }
  void publish_as_loaned_msg(const rclcpp::SerializedMessage& message) { publish(message); }
};

}  // namespace rclcpp
