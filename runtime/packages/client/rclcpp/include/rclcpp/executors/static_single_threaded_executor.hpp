// The same as the single-threaded one, which here also looks for entities only when they change.
#pragma once

#include "rclcpp/executors/single_threaded_executor.hpp"

namespace rclcpp {
namespace executors {

class StaticSingleThreadedExecutor : public SingleThreadedExecutor {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(StaticSingleThreadedExecutor)
  explicit StaticSingleThreadedExecutor(
      const rclcpp::ExecutorOptions& options = rclcpp::ExecutorOptions())
      : SingleThreadedExecutor(options) {}
};

}  // namespace executors
}  // namespace rclcpp
