// Messages out of a pool of fixed size.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <new>
#include <stdexcept>

#include "rclcpp/macros.hpp"
#include "rclcpp/message_memory_strategy.hpp"
#include "rosidl_runtime_cpp/traits.hpp"

namespace rclcpp {
namespace strategies {
namespace message_pool_memory_strategy {

template <typename MessageT, size_t Size,
          typename std::enable_if<rosidl_generator_traits::has_fixed_size<MessageT>::value>::type* =
              nullptr>
class MessagePoolMemoryStrategy : public message_memory_strategy::MessageMemoryStrategy<MessageT> {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(MessagePoolMemoryStrategy)

  /// Throws std::runtime_error when all are in use. A message goes back with its last owner.
  std::shared_ptr<MessageT> borrow_message() override {
    const std::lock_guard<std::mutex> lock(pool_->mutex);
    for (Slot& slot : pool_->slots) {
      if (!slot.used) {
        slot.used = true;
        return std::shared_ptr<MessageT>(new (slot.bytes) MessageT(),
                                         [pool = pool_, &slot](MessageT* message) {
                                           const std::lock_guard<std::mutex> lock(pool->mutex);
                                           message->~MessageT();
                                           slot.used = false;
                                         });
      }
    }
    throw std::runtime_error("No more free slots in the pool");
  }
  void return_message(std::shared_ptr<MessageT>& msg) override { static_cast<void>(msg); }

 private:
  struct Slot {
    alignas(MessageT) unsigned char bytes[sizeof(MessageT)];
    bool used = false;
  };
  struct Pool {
    std::mutex mutex;
    std::array<Slot, Size> slots;
  };
  std::shared_ptr<Pool> pool_ = std::make_shared<Pool>();
};

}  // namespace message_pool_memory_strategy
}  // namespace strategies
}  // namespace rclcpp
