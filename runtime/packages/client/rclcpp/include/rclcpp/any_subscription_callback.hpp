// Any of the forms a subscription's callback may have, as one function.
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "rclcpp/message_info.hpp"
#include "rclcpp/serialized_message.hpp"
#include "rclcpp/type_adapter.hpp"

namespace rclcpp {
namespace detail {

template <typename T>
inline constexpr bool always_false_v = false;

/// A message in hand: owned, or shared with others (then it must not be changed).
template <typename T>
struct InHand {
  std::unique_ptr<T> owned;
  std::shared_ptr<const T> shared;
  // Made shared by the caller for this one listener: may be handed out as non-const.
  std::shared_ptr<T> mine;

  const T& get() const { return owned ? *owned : mine ? *mine : *shared; }
  std::unique_ptr<T> take_unique() { return owned ? std::move(owned) : std::make_unique<T>(get()); }
  std::shared_ptr<T> take_shared() {
    return mine ? std::move(mine) : std::shared_ptr<T>(take_unique());
  }
  std::shared_ptr<const T> take_shared_const() {
    return shared ? std::move(shared) : std::shared_ptr<const T>(take_shared());
  }
};

template <typename CallbackT, typename T, typename... InfoT>
inline constexpr bool takes_message_v =
    std::is_invocable_v<CallbackT&, const T&, InfoT...> ||
    std::is_invocable_v<CallbackT&, std::shared_ptr<T>, InfoT...> ||
    std::is_invocable_v<CallbackT&, std::unique_ptr<T>, InfoT...>;

/// Calls with the form of the message that the callback asks for.
template <typename T, typename CallbackT, typename... InfoT>
void call_with(CallbackT& callback, InHand<T>& message, const InfoT&... info) {
  if constexpr (std::is_invocable_v<CallbackT&, const T&, InfoT...>) {
    callback(message.get(), info...);
  } else if constexpr (std::is_invocable_v<CallbackT&, std::shared_ptr<const T>, InfoT...>) {
    callback(message.take_shared_const(), info...);
  } else if constexpr (std::is_invocable_v<CallbackT&, std::shared_ptr<T>, InfoT...>) {
    callback(message.take_shared(), info...);
  } else {
    callback(message.take_unique(), info...);
  }
}

/// Whether the callback wants a message of its own.
template <typename T, typename CallbackT, typename... InfoT>
constexpr bool wants_ownership() {
  return !std::is_invocable_v<CallbackT&, const T&, InfoT...> &&
         !std::is_invocable_v<CallbackT&, std::shared_ptr<const T>, InfoT...>;
}

}  // namespace detail

template <typename MessageT, typename AllocatorT = std::allocator<void>>
class AnySubscriptionCallback {
 public:
  using SubscribedType = typename rclcpp::TypeAdapter<MessageT>::custom_type;
  using ROSMessageType = typename rclcpp::TypeAdapter<MessageT>::ros_message_type;

  AnySubscriptionCallback() = default;
  explicit AnySubscriptionCallback(const AllocatorT&) {}

  template <typename CallbackT>
  AnySubscriptionCallback& set(CallbackT callback) {
    using InfoT = rclcpp::MessageInfo;
    if constexpr (detail::takes_message_v<CallbackT, ROSMessageType>) {
      set_message<ROSMessageType>(std::move(callback));
    } else if constexpr (detail::takes_message_v<CallbackT, ROSMessageType, InfoT>) {
      set_message<ROSMessageType, InfoT>(std::move(callback));
    } else if constexpr (detail::takes_message_v<CallbackT, SubscribedType>) {
      set_custom(std::move(callback));
    } else if constexpr (detail::takes_message_v<CallbackT, SubscribedType, InfoT>) {
      set_custom<InfoT>(std::move(callback));
    } else if constexpr (detail::takes_message_v<CallbackT, SerializedMessage>) {
      set_serialized(std::move(callback));
    } else if constexpr (detail::takes_message_v<CallbackT, SerializedMessage, InfoT>) {
      set_serialized<InfoT>(std::move(callback));
    } else {
      static_assert(detail::always_false_v<CallbackT>,
                    "a subscription callback takes the message as const M &, "
                    "std::unique_ptr<M>, std::shared_ptr<const M> or std::shared_ptr<M> (or a "
                    "rclcpp::SerializedMessage so), and may take a const rclcpp::MessageInfo &");
    }
    return *this;
  }

  void dispatch(std::unique_ptr<ROSMessageType> message, const MessageInfo& info) {
    detail::InHand<ROSMessageType> in_hand;
    in_hand.owned = std::move(message);
    call(in_hand, info);
  }
  void dispatch(std::shared_ptr<ROSMessageType> message, const MessageInfo& info) {
    detail::InHand<ROSMessageType> in_hand;
    in_hand.mine = std::move(message);
    call(in_hand, info);
  }
  void dispatch(std::shared_ptr<const ROSMessageType> message, const MessageInfo& info) {
    detail::InHand<ROSMessageType> in_hand;
    in_hand.shared = std::move(message);
    call(in_hand, info);
  }
  void dispatch(std::shared_ptr<SerializedMessage> message, const MessageInfo& info) {
    if (!serialized_) {
      throw std::runtime_error("dispatch called on an unset AnySubscriptionCallback");
    }
    detail::InHand<SerializedMessage> in_hand;
    in_hand.mine = std::move(message);
    serialized_(in_hand, info);
  }

  bool is_serialized() const { return static_cast<bool>(serialized_); }
  bool takes_ownership() const { return takes_ownership_; }
  bool reads_info() const { return reads_info_; }

 private:
  void call(detail::InHand<ROSMessageType>& message, const MessageInfo& info) {
    if (!function_) {
      throw std::runtime_error("dispatch called on an unset AnySubscriptionCallback");
    }
    function_(message, info);
  }

  template <typename T, typename... InfoT, typename CallbackT>
  void set_message(CallbackT callback) {
    takes_ownership_ = detail::wants_ownership<T, CallbackT, InfoT...>();
    reads_info_ = sizeof...(InfoT) != 0;
    function_ = [callback = std::move(callback)](detail::InHand<T>& message,
                                                 const MessageInfo& info) mutable {
      if constexpr (sizeof...(InfoT) == 0) {
        detail::call_with<T>(callback, message);
      } else {
        detail::call_with<T>(callback, message, info);
      }
    };
  }

  template <typename... InfoT, typename CallbackT>
  void set_custom(CallbackT callback) {
    reads_info_ = sizeof...(InfoT) != 0;
    function_ = [callback = std::move(callback)](detail::InHand<ROSMessageType>& message,
                                                 const MessageInfo& info) mutable {
      detail::InHand<SubscribedType> custom;
      custom.owned = std::make_unique<SubscribedType>();
      rclcpp::TypeAdapter<MessageT>::convert_to_custom(message.get(), *custom.owned);
      if constexpr (sizeof...(InfoT) == 0) {
        detail::call_with<SubscribedType>(callback, custom);
      } else {
        detail::call_with<SubscribedType>(callback, custom, info);
      }
    };
  }

  template <typename... InfoT, typename CallbackT>
  void set_serialized(CallbackT callback) {
    reads_info_ = sizeof...(InfoT) != 0;
    serialized_ = [callback = std::move(callback)](detail::InHand<SerializedMessage>& message,
                                                   const MessageInfo& info) mutable {
      if constexpr (sizeof...(InfoT) == 0) {
        detail::call_with<SerializedMessage>(callback, message);
      } else {
        detail::call_with<SerializedMessage>(callback, message, info);
      }
    };
  }

  std::function<void(detail::InHand<ROSMessageType>&, const MessageInfo&)> function_;
  std::function<void(detail::InHand<SerializedMessage>&, const MessageInfo&)> serialized_;
  bool takes_ownership_ = false;
  bool reads_info_ = false;
};

}  // namespace rclcpp
