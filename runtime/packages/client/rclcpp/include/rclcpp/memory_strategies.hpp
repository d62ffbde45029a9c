// The default memory strategy.
#pragma once

#include "rclcpp/memory_strategy.hpp"
#include "rclcpp/strategies/allocator_memory_strategy.hpp"

namespace rclcpp {
namespace memory_strategies {

inline memory_strategy::MemoryStrategy::SharedPtr create_default_strategy() {
  return std::make_shared<allocator_memory_strategy::AllocatorMemoryStrategy<>>();
}

}  // namespace memory_strategies
}  // namespace rclcpp
