// A node's identity: names, context, callback groups.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include "rclcpp/callback_group.hpp"
#include "rclcpp/context.hpp"
#include "rclcpp/guard_condition.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/detail/node_interfaces_helpers.hpp"
#include "rclcpp/visibility_control.hpp"

namespace ros2wasm {
struct Arguments;
}

namespace rclcpp {
namespace node_interfaces {

class NodeBaseInterface {
 public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeBaseInterface)

  virtual ~NodeBaseInterface() = default;

  virtual const char* get_name() const = 0;
  virtual const char* get_namespace() const = 0;
  virtual const char* get_fully_qualified_name() const = 0;
  virtual rclcpp::Context::SharedPtr get_context() = 0;
  virtual rclcpp::CallbackGroup::SharedPtr create_callback_group(
      rclcpp::CallbackGroupType group_type,
      bool automatically_add_to_executor_with_node = true) = 0;
  virtual rclcpp::CallbackGroup::SharedPtr get_default_callback_group() = 0;
  virtual bool callback_group_in_node(rclcpp::CallbackGroup::SharedPtr group) = 0;

  using CallbackGroupFunction = std::function<void(rclcpp::CallbackGroup::SharedPtr)>;
  virtual void for_each_callback_group(const CallbackGroupFunction& func) = 0;
  virtual std::atomic_bool& get_associated_with_executor_atomic() = 0;
  virtual rclcpp::GuardCondition& get_notify_guard_condition() = 0;
  virtual rclcpp::GuardCondition::SharedPtr get_shared_notify_guard_condition() = 0;
  virtual void trigger_notify_guard_condition() = 0;
  virtual bool get_use_intra_process_default() const = 0;
  virtual bool get_enable_topic_statistics_default() const = 0;
  /// The full name, remapped unless `only_expand`. Throws InvalidTopicNameError and its kin.
  virtual std::string resolve_topic_or_service_name(const std::string& name, bool is_service,
                                                    bool only_expand = false) const = 0;

  /// The node's number on the bus.
  virtual int32_t get_node_id() const = 0;
  /// "ns.name", under which the node logs.
  virtual const char* get_logger_name() const = 0;
  /// The node's own arguments, and the program's, or null.
  virtual const ros2wasm::Arguments* get_local_arguments() const = 0;
  virtual const ros2wasm::Arguments* get_global_arguments() const = 0;
};

}  // namespace node_interfaces
}  // namespace rclcpp

RCLCPP_NODE_INTERFACE_HELPERS_SUPPORT(rclcpp::node_interfaces::NodeBaseInterface, base)
