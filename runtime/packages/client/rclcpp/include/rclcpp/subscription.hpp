// A subscription to one message type, or to a type of the user's through a type adapter.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "rclcpp/any_subscription_callback.hpp"
#include "rclcpp/message_memory_strategy.hpp"
#include "rclcpp/subscription_base.hpp"
#include "rclcpp/type_adapter.hpp"

namespace rclcpp {

template <typename MessageT, typename AllocatorT = std::allocator<void>,
          typename SubscribedT = typename rclcpp::TypeAdapter<MessageT>::custom_type,
          typename ROSMessageT = typename rclcpp::TypeAdapter<MessageT>::ros_message_type,
          typename MessageMemoryStrategyT =
              rclcpp::message_memory_strategy::MessageMemoryStrategy<ROSMessageT, AllocatorT>>
class Subscription : public SubscriptionBase {
 public:
  using SubscribedType = SubscribedT;
  using ROSMessageType = ROSMessageT;
  using MessageMemoryStrategyType = MessageMemoryStrategyT;
  using MessageDeleter = std::default_delete<ROSMessageT>;
  using ConstMessageSharedPtr = std::shared_ptr<const ROSMessageT>;
  using MessageUniquePtr = std::unique_ptr<ROSMessageT>;

  RCLCPP_SMART_PTR_DEFINITIONS(Subscription)

  Subscription(node_interfaces::NodeBaseInterface* node_base, const std::string& topic_name,
               const rclcpp::QoS& qos, AnySubscriptionCallback<MessageT, AllocatorT> callback,
               const SubscriptionOptionsWithAllocator<AllocatorT>& options)
      : SubscriptionBase(node_base, detail::type_support_of<ROSMessageT>(), topic_name, qos,
                         options,
                         callback.is_serialized() ? DeliveredMessageKind::SERIALIZED_MESSAGE
                                                  : DeliveredMessageKind::ROS_MESSAGE),
        callback_(std::move(callback)) {}

  /// Takes one message; false when there is none.
  bool take(ROSMessageT& message_out, rclcpp::MessageInfo& message_info_out) {
    return this->take_type_erased(&message_out, message_info_out);
  }

  template <typename TakeT>
  std::enable_if_t<std::is_same_v<TakeT, SubscribedT> && !std::is_same_v<TakeT, ROSMessageT>, bool>
  take(TakeT& message_out, rclcpp::MessageInfo& message_info_out) {
    ROSMessageT ros_message;
    if (!take(ros_message, message_info_out)) {
      return false;
    }
    rclcpp::TypeAdapter<MessageT>::convert_to_custom(ros_message, message_out);
    return true;
  }

  std::shared_ptr<void> create_message() override { return std::make_shared<ROSMessageT>(); }

  void handle_message(std::shared_ptr<void>& message,
                      const rclcpp::MessageInfo& message_info) override {
    callback_.dispatch(std::static_pointer_cast<ROSMessageT>(message), message_info);
  }

  void handle_serialized_message(
      const std::shared_ptr<rclcpp::SerializedMessage>& serialized_message,
      const rclcpp::MessageInfo& message_info) override {
    callback_.dispatch(serialized_message, message_info);
  }

  bool takes_ownership() const override { return callback_.takes_ownership(); }

 protected:
  bool reads_info() const override { return callback_.reads_info(); }

  void handle_bytes(const uint8_t* bytes, size_t size,
                    const rclcpp::MessageInfo& message_info) override {
    auto message = std::make_unique<ROSMessageT>();
    if (!detail::callbacks_of(this->get_message_type_support_handle())
             .deserialize(bytes, size, message.get())) {
      this->report_malformed();
      return;
    }
    callback_.dispatch(std::move(message), message_info);
  }

  void handle_local(detail::LocalMessage message,
                    const rclcpp::MessageInfo& message_info) override {
    if (message.owned) {
      callback_.dispatch(
          std::unique_ptr<ROSMessageT>(static_cast<ROSMessageT*>(message.owned.release())),
          message_info);
    } else {
      callback_.dispatch(std::static_pointer_cast<const ROSMessageT>(message.shared), message_info);
    }
  }

 private:
  RCLCPP_DISABLE_COPY(Subscription)
  AnySubscriptionCallback<MessageT, AllocatorT> callback_;
};

}  // namespace rclcpp
