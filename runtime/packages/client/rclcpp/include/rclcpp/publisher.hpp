// A publisher of one message type, or of a type of the user's through a type adapter.
#pragma once

#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "rclcpp/loaned_message.hpp"
#include "rclcpp/publisher_base.hpp"
#include "rclcpp/type_adapter.hpp"

namespace rclcpp {

template <typename MessageT, typename AllocatorT = std::allocator<void>>
class Publisher : public PublisherBase {
 public:
  /// The type that the program publishes, and the type that goes over the bus.
  using PublishedType = typename rclcpp::TypeAdapter<MessageT>::custom_type;
  using ROSMessageType = typename rclcpp::TypeAdapter<MessageT>::ros_message_type;

  using PublishedTypeDeleter = std::default_delete<PublishedType>;
  using ROSMessageTypeDeleter = std::default_delete<ROSMessageType>;
  using MessageAllocator =
      typename std::allocator_traits<AllocatorT>::template rebind_alloc<ROSMessageType>;
  using MessageDeleter = ROSMessageTypeDeleter;
  using MessageUniquePtr = std::unique_ptr<ROSMessageType>;
  using MessageSharedPtr = std::shared_ptr<const ROSMessageType>;

  RCLCPP_SMART_PTR_DEFINITIONS(Publisher<MessageT, AllocatorT>)

  Publisher(node_interfaces::NodeBaseInterface* node_base, const std::string& topic,
            const rclcpp::QoS& qos, const PublisherOptionsWithAllocator<AllocatorT>& options)
      : PublisherBase(node_base, topic, detail::type_support_of<ROSMessageType>(), qos, options,
                      &detail::object_functions<ROSMessageType>()) {}

  /// A message from the middleware; here it is an ordinary one.
  rclcpp::LoanedMessage<ROSMessageType, AllocatorT> borrow_loaned_message() {
    return rclcpp::LoanedMessage<ROSMessageType, AllocatorT>(*this);
  }

  template <typename T, typename DeleterT>
  std::enable_if_t<std::is_same_v<T, ROSMessageType>> publish(std::unique_ptr<T, DeleterT> msg) {
    if (!this->is_intra_process()) {
      this->do_inter_process_publish(*msg);
    } else if constexpr (std::is_same_v<DeleterT, std::default_delete<T>>) {
      this->publish_owned(msg.release());
    } else {
      this->publish_owned(new T(*msg));
    }
  }

  template <typename T>
  std::enable_if_t<std::is_same_v<T, ROSMessageType>> publish(const T& msg) {
    if (!this->is_intra_process()) {
      this->do_inter_process_publish(msg);
    } else {
      this->publish_owned(new T(msg));
    }
  }

  template <typename T, typename DeleterT>
  std::enable_if_t<std::is_same_v<T, PublishedType> && !std::is_same_v<T, ROSMessageType>> publish(
      std::unique_ptr<T, DeleterT> msg) {
    publish(*msg);
  }

  template <typename T>
  std::enable_if_t<std::is_same_v<T, PublishedType> && !std::is_same_v<T, ROSMessageType>> publish(
      const T& msg) {
    auto ros_message = std::make_unique<ROSMessageType>();
    rclcpp::TypeAdapter<MessageT>::convert_to_ros_message(msg, *ros_message);
    publish(std::move(ros_message));
  }

  void publish(const rcl_serialized_message_t& serialized_msg) {
    this->publish_bytes(serialized_msg.buffer, serialized_msg.buffer_length);
  }

  void publish(const SerializedMessage& serialized_msg) {
    publish(serialized_msg.get_rcl_serialized_message());
  }

  void publish(rclcpp::LoanedMessage<ROSMessageType, AllocatorT>&& loaned_msg) {
    if (!loaned_msg.is_valid()) {
      throw std::runtime_error("loaned message is not valid");
    }
    publish(loaned_msg.release());
  }

 protected:
  void do_inter_process_publish(const ROSMessageType& msg) { this->publish_object(&msg); }
};

}  // namespace rclcpp
