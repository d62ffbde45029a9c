// A memory strategy with an allocator of the user's; kept for code that makes one.
#pragma once

#include <memory>

#include "rclcpp/memory_strategy.hpp"

namespace rclcpp {
namespace memory_strategies {
namespace allocator_memory_strategy {

template <typename Alloc = std::allocator<void>>
class AllocatorMemoryStrategy : public memory_strategy::MemoryStrategy {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(AllocatorMemoryStrategy<Alloc>)
  AllocatorMemoryStrategy() = default;
  explicit AllocatorMemoryStrategy(std::shared_ptr<Alloc> allocator) : allocator_(allocator) {}

 private:
  std::shared_ptr<Alloc> allocator_;
};

}  // namespace allocator_memory_strategy
}  // namespace memory_strategies
}  // namespace rclcpp
