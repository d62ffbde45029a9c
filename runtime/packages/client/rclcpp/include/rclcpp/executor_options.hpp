// The options of an executor.
#pragma once

#include <cstddef>
#include <memory>

#include "rclcpp/contexts/default_context.hpp"
#include "rclcpp/memory_strategy.hpp"

namespace rclcpp {

struct ExecutorOptions {
  /// Kept for code that sets it; the executors manage their own memory.
  rclcpp::memory_strategy::MemoryStrategy::SharedPtr memory_strategy;
  rclcpp::Context::SharedPtr context = rclcpp::contexts::get_global_default_context();
  size_t max_conditions = 0;
};

}  // namespace rclcpp
