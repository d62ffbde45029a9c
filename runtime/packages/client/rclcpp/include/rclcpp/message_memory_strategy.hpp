// Where messages come from. The library makes its own; the type stays for code that passes one.
#pragma once

#include <memory>

#include "rclcpp/macros.hpp"
#include "rclcpp/serialized_message.hpp"

namespace rclcpp {
namespace message_memory_strategy {

template <typename MessageT, typename Alloc = std::allocator<void>>
class MessageMemoryStrategy {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(MessageMemoryStrategy)

  MessageMemoryStrategy() = default;
  explicit MessageMemoryStrategy(std::shared_ptr<Alloc>) {}
  virtual ~MessageMemoryStrategy() = default;

  static SharedPtr create_default() { return nullptr; }
  virtual std::shared_ptr<MessageT> borrow_message() { return std::make_shared<MessageT>(); }
  virtual void return_message(std::shared_ptr<MessageT>& message) { message.reset(); }
};

}  // namespace message_memory_strategy
}  // namespace rclcpp
