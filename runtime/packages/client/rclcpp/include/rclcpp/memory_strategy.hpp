// A name that code passes to executors. Executors here manage their own memory.
#pragma once

#include "rclcpp/macros.hpp"

namespace rclcpp {
namespace memory_strategy {

class MemoryStrategy {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(MemoryStrategy)
  virtual ~MemoryStrategy() = default;
};

}  // namespace memory_strategy
}  // namespace rclcpp
