// A message borrowed from the middleware. The bus lends none: it lives in the program's memory.
#pragma once

#include <memory>
#include <utility>

#include "rclcpp/publisher_base.hpp"

namespace rclcpp {

template <typename MessageT, typename AllocatorT = std::allocator<void>>
class LoanedMessage {
 public:
  explicit LoanedMessage(const rclcpp::PublisherBase&) : message_(std::make_unique<MessageT>()) {}
  LoanedMessage(const rclcpp::PublisherBase& publisher, const AllocatorT&)
      : LoanedMessage(publisher) {}
  LoanedMessage(LoanedMessage&&) = default;
  virtual ~LoanedMessage() = default;

  bool is_valid() const { return message_ != nullptr; }
  virtual MessageT& get() const { return *message_; }
  std::unique_ptr<MessageT> release() { return std::move(message_); }

 private:
  std::unique_ptr<MessageT> message_;
};

}  // namespace rclcpp
