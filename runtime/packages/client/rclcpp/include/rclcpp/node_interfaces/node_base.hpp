// A node's identity, for real.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "rclcpp/node_interfaces/node_base_interface.hpp"

namespace ros2wasm {
class NodeEntry;
}

namespace rclcpp {
namespace node_interfaces {

/// The part of a node's options that NodeBase uses.
struct NodeBaseOptions {
  std::vector<std::string> arguments;
  bool use_global_arguments = true;
  bool use_intra_process_default = false;
  bool enable_topic_statistics_default = false;
};

class NodeBase : public NodeBaseInterface, public std::enable_shared_from_this<NodeBase> {
 public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeBase)

  /// Applies the remap rules for the node's name and namespace. Throws InvalidNodeNameError,
  /// InvalidNamespaceError, RCLError when the context is not valid.
  NodeBase(const std::string& node_name, const std::string& namespace_,
           rclcpp::Context::SharedPtr context, const NodeBaseOptions& options,
           rclcpp::CallbackGroup::SharedPtr default_callback_group = nullptr);
  ~NodeBase() override;

  const char* get_name() const override { return name_.c_str(); }
  const char* get_namespace() const override { return namespace_.c_str(); }
  const char* get_fully_qualified_name() const override { return full_name_.c_str(); }
  rclcpp::Context::SharedPtr get_context() override { return context_; }
  rclcpp::CallbackGroup::SharedPtr create_callback_group(
      rclcpp::CallbackGroupType group_type,
      bool automatically_add_to_executor_with_node = true) override;
  rclcpp::CallbackGroup::SharedPtr get_default_callback_group() override;
  bool callback_group_in_node(rclcpp::CallbackGroup::SharedPtr group) override;
  void for_each_callback_group(const CallbackGroupFunction& func) override;
  std::atomic_bool& get_associated_with_executor_atomic() override {
    return associated_with_executor_;
  }
  rclcpp::GuardCondition& get_notify_guard_condition() override;
  rclcpp::GuardCondition::SharedPtr get_shared_notify_guard_condition() override;
  void trigger_notify_guard_condition() override;
  bool get_use_intra_process_default() const override { return options_.use_intra_process_default; }
  bool get_enable_topic_statistics_default() const override {
    return options_.enable_topic_statistics_default;
  }
  std::string resolve_topic_or_service_name(const std::string& name, bool is_service,
                                            bool only_expand = false) const override;
  int32_t get_node_id() const override;
  const char* get_logger_name() const override { return logger_name_.c_str(); }
  const ros2wasm::Arguments* get_local_arguments() const override { return arguments_.get(); }
  const ros2wasm::Arguments* get_global_arguments() const override {
    return global_arguments_.get();
  }

 private:
  RCLCPP_DISABLE_COPY(NodeBase)

  rclcpp::Context::SharedPtr context_;
  const NodeBaseOptions options_;
  std::shared_ptr<const ros2wasm::Arguments> arguments_;
  std::shared_ptr<const ros2wasm::Arguments> global_arguments_;
  std::string name_;
  std::string namespace_;
  std::string full_name_;
  std::string logger_name_;
  std::unique_ptr<ros2wasm::NodeEntry> entry_;
  rclcpp::CallbackGroup::SharedPtr default_callback_group_;
  std::mutex callback_groups_mutex_;
  std::vector<rclcpp::CallbackGroup::WeakPtr> callback_groups_;
  std::atomic_bool associated_with_executor_{false};
  rclcpp::GuardCondition::SharedPtr notify_guard_condition_;
};

}  // namespace node_interfaces
}  // namespace rclcpp
