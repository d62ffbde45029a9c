// Type traits for the parameter of a subscription's callback.
#pragma once

#include <memory>
#include <type_traits>

#include "rclcpp/function_traits.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/serialized_message.hpp"
#include "rclcpp/subscription_options.hpp"

namespace rclcpp {
namespace subscription_traits {

template <typename T>
struct is_serialized_subscription_argument : std::false_type {};
template <>
struct is_serialized_subscription_argument<SerializedMessage> : std::true_type {};
template <>
struct is_serialized_subscription_argument<std::shared_ptr<SerializedMessage>> : std::true_type {};

template <typename T>
struct is_serialized_subscription : is_serialized_subscription_argument<T> {};
template <typename CallbackT>
struct is_serialized_callback
    : is_serialized_subscription_argument<
          typename function_traits::function_traits<CallbackT>::template argument_type<0>> {};

template <typename MessageT>
struct extract_message_type {
  using type = std::remove_cv_t<std::remove_reference_t<MessageT>>;
};
template <typename MessageT>
struct extract_message_type<std::shared_ptr<MessageT>> : extract_message_type<MessageT> {};
template <typename MessageT, typename Deleter>
struct extract_message_type<std::unique_ptr<MessageT, Deleter>> : extract_message_type<MessageT> {};

template <typename CallbackT>
struct has_message_type
    : extract_message_type<
          typename function_traits::function_traits<CallbackT>::template argument_type<0>> {};

}  // namespace subscription_traits
}  // namespace rclcpp
