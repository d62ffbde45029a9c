// A message, and when it was received.
#pragma once

#include <functional>
#include <memory>
#include <type_traits>

#include "rclcpp/rclcpp.hpp"

namespace message_filters {

template <typename M>
struct DefaultMessageCreator {
  std::shared_ptr<M> operator()() { return std::make_shared<M>(); }
};

/// A non-const event of a message that others also read returns a copy, made at the first call.
template <typename M>
class MessageEvent {
 public:
  using ConstMessage = std::add_const_t<M>;
  using Message = std::remove_const_t<M>;
  using MessagePtr = std::shared_ptr<Message>;
  using ConstMessagePtr = std::shared_ptr<ConstMessage>;
  using CreateFunction = std::function<MessagePtr()>;

  MessageEvent() = default;
  MessageEvent(const MessageEvent<Message>& rhs)  // NOLINT: conversion wanted
      : MessageEvent(rhs, rhs.nonConstWillCopy()) {}
  MessageEvent(const MessageEvent<ConstMessage>& rhs)  // NOLINT: conversion wanted
      : MessageEvent(rhs, rhs.nonConstWillCopy()) {}
  MessageEvent(const MessageEvent<Message>& rhs, bool nonconst_need_copy) {
    init(rhs.getConstMessage(), rhs.getReceiptTime(), nonconst_need_copy, rhs.getMessageFactory());
  }
  MessageEvent(const MessageEvent<ConstMessage>& rhs, bool nonconst_need_copy) {
    init(rhs.getConstMessage(), rhs.getReceiptTime(), nonconst_need_copy, rhs.getMessageFactory());
  }
  /// Received now.
  MessageEvent(const ConstMessagePtr& message)  // NOLINT: conversion wanted
      : MessageEvent(message, rclcpp::Clock().now()) {}
  MessageEvent(const ConstMessagePtr& message, rclcpp::Time receipt_time)
      : MessageEvent(message, receipt_time, true, DefaultMessageCreator<Message>()) {}
  MessageEvent(const ConstMessagePtr& message, rclcpp::Time receipt_time, bool nonconst_need_copy,
               const CreateFunction& create) {
    init(message, receipt_time, nonconst_need_copy, create);
  }

  void init(const ConstMessagePtr& message, rclcpp::Time receipt_time, bool nonconst_need_copy,
            const CreateFunction& create) {
    message_ = message;
    message_copy_.reset();
    receipt_time_ = receipt_time;
    nonconst_need_copy_ = nonconst_need_copy;
    create_ = create;
  }

  void operator=(const MessageEvent<Message>& rhs) {
    init(rhs.getConstMessage(), rhs.getReceiptTime(), rhs.nonConstWillCopy(),
         rhs.getMessageFactory());
  }
  void operator=(const MessageEvent<ConstMessage>& rhs) {
    init(rhs.getConstMessage(), rhs.getReceiptTime(), rhs.nonConstWillCopy(),
         rhs.getMessageFactory());
  }

  /// The message; of a non-const event that must not share it, a copy.
  std::shared_ptr<M> getMessage() const {
    if constexpr (std::is_const_v<M>) {
      return message_;
    } else {
      if (!nonconst_need_copy_ || !message_) {
        return std::const_pointer_cast<Message>(message_);
      }
      if (!message_copy_) {
        message_copy_ = create_();
        *message_copy_ = *message_;
      }
      return message_copy_;
    }
  }
  const std::shared_ptr<ConstMessage>& getConstMessage() const { return message_; }
  rclcpp::Time getReceiptTime() const { return receipt_time_; }
  bool nonConstWillCopy() const { return nonconst_need_copy_; }
  bool getMessageWillCopy() const { return !std::is_const_v<M> && nonconst_need_copy_; }
  const CreateFunction& getMessageFactory() const { return create_; }

  bool operator<(const MessageEvent<M>& rhs) const {
    if (message_ != rhs.message_) {
      return message_ < rhs.message_;
    }
    if (receipt_time_ != rhs.receipt_time_) {
      return receipt_time_ < rhs.receipt_time_;
    }
    return nonconst_need_copy_ < rhs.nonconst_need_copy_;
  }
  bool operator==(const MessageEvent<M>& rhs) const {
    return message_ == rhs.message_ && receipt_time_ == rhs.receipt_time_ &&
           nonconst_need_copy_ == rhs.nonconst_need_copy_;
  }
  bool operator!=(const MessageEvent<M>& rhs) const { return !(*this == rhs); }

 private:
  ConstMessagePtr message_;
  mutable MessagePtr message_copy_;
  rclcpp::Time receipt_time_;
  bool nonconst_need_copy_ = true;
  CreateFunction create_;
};

}  // namespace message_filters
