// The context that is meant when none is named.
#pragma once

#include "rclcpp/context.hpp"

namespace rclcpp {
namespace contexts {

class DefaultContext : public rclcpp::Context {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(DefaultContext)
  DefaultContext() = default;
};

DefaultContext::SharedPtr get_global_default_context();

}  // namespace contexts
}  // namespace rclcpp
