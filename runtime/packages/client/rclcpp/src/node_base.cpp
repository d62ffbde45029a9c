// A node's identity: names are remapped and checked, then the node enters the graph.
#include "rclcpp/node_interfaces/node_base.hpp"

#include <algorithm>

#include "rclcpp/detail/executable.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/expand_topic_or_service_name.hpp"
#include "ros2wasm/arguments.hpp"
#include "ros2wasm/endpoint.hpp"
#include "ros2wasm/names.hpp"

namespace rclcpp {
namespace {

[[noreturn]] void refuse_name(const std::string& name, const ros2wasm::NameProblem& why,
                              bool is_service) {
  if (is_service) {
    throw exceptions::InvalidServiceNameError(name.c_str(), why.message, why.index);
  }
  throw exceptions::InvalidTopicNameError(name.c_str(), why.message, why.index);
}

// The names of the node are good.
std::string expand_name(const std::string& name, const std::string& node_name,
                        const std::string& ns, bool is_service) {
  if (const auto problem = ros2wasm::check_topic_name(name)) {
    refuse_name(name, *problem, is_service);
  }
  std::string full = ros2wasm::expand_topic_name(name, node_name, ns);
  if (full.empty()) {
    refuse_name(name, {"unknown substitution", name.find('{')}, is_service);
  }
  return full;
}

}  // namespace

std::string expand_topic_or_service_name(const std::string& name, const std::string& node_name,
                                         const std::string& namespace_, bool is_service) {
  if (const auto problem = ros2wasm::check_node_name(node_name)) {
    throw exceptions::InvalidNodeNameError(node_name.c_str(), problem->message, problem->index);
  }
  if (const auto problem = ros2wasm::check_namespace(namespace_)) {
    throw exceptions::InvalidNamespaceError(namespace_.c_str(), problem->message, problem->index);
  }
  std::string full = expand_name(name, node_name, namespace_, is_service);
  if (const auto problem = ros2wasm::check_full_topic_name(full)) {
    refuse_name(full, *problem, is_service);
  }
  return full;
}

namespace node_interfaces {
namespace {

std::shared_ptr<const ros2wasm::Arguments> parse_local(const std::vector<std::string>& arguments) {
  if (arguments.empty()) {
    return nullptr;
  }
  try {
    auto parsed = std::make_shared<ros2wasm::Arguments>(ros2wasm::parse_arguments(arguments));
    if (!parsed->unknown_ros_arguments.empty()) {
      throw exceptions::UnknownROSArgsError(std::move(parsed->unknown_ros_arguments));
    }
    return parsed;
  } catch (const std::invalid_argument& error) {
    rcutils_set_error_state(error.what(), __FILE__, __LINE__);
    exceptions::throw_from_rcl_error(RCL_RET_INVALID_ROS_ARGS, "failed to parse arguments");
  }
}

std::string absolute(const std::string& ns) {
  return ns.empty() ? "/" : ns[0] == '/' ? ns : "/" + ns;
}

std::string logger_name_of(const std::string& full_name) {
  std::string name = full_name.substr(1);
  std::replace(name.begin(), name.end(), '/', '.');
  return name;
}

}  // namespace

NodeBase::NodeBase(const std::string& node_name, const std::string& ns,
                   rclcpp::Context::SharedPtr context, const NodeBaseOptions& options,
                   rclcpp::CallbackGroup::SharedPtr default_callback_group)
    : context_(std::move(context)),
      options_(options),
      arguments_(parse_local(options.arguments)),
      global_arguments_(options.use_global_arguments ? context_->get_global_arguments() : nullptr),
      default_callback_group_(std::move(default_callback_group)) {
  if (!context_->is_valid()) {
    rcutils_set_error_state(
        "the given context is not valid, either rcl_init() was not called or rcl_shutdown() was "
        "called.",
        __FILE__, __LINE__);
    exceptions::throw_from_rcl_error(RCL_RET_NOT_INIT, "failed to initialize rcl node");
  }
  if (const auto problem = ros2wasm::check_node_name(node_name)) {
    throw exceptions::InvalidNodeNameError(node_name.c_str(), problem->message, problem->index);
  }
  const std::string wanted_namespace = absolute(ns);
  if (const auto problem = ros2wasm::check_namespace(wanted_namespace)) {
    throw exceptions::InvalidNamespaceError(wanted_namespace.c_str(), problem->message,
                                            problem->index);
  }
  const ros2wasm::Arguments* local = arguments_.get();
  const ros2wasm::Arguments* global = global_arguments_.get();
  name_ = ros2wasm::remap_node_name(local, global, node_name);
  namespace_ = ros2wasm::remap_node_namespace(local, global, node_name, wanted_namespace);
  full_name_ = ros2wasm::join_name(namespace_, name_);
  logger_name_ = logger_name_of(full_name_);
  entry_ = std::make_unique<ros2wasm::NodeEntry>(name_, namespace_);
  if (!default_callback_group_) {
    default_callback_group_ = create_callback_group(CallbackGroupType::MutuallyExclusive);
  } else {
    callback_groups_.push_back(default_callback_group_);
  }
  notify_guard_condition_ = std::make_shared<rclcpp::GuardCondition>(context_);
}

NodeBase::~NodeBase() {
  detail::bump_entities_version();
}

int32_t NodeBase::get_node_id() const {
  return entry_->id();
}

rclcpp::CallbackGroup::SharedPtr NodeBase::create_callback_group(
    rclcpp::CallbackGroupType group_type, bool automatically_add_to_executor_with_node) {
  auto group = std::make_shared<rclcpp::CallbackGroup>(group_type, context_,
                                                       automatically_add_to_executor_with_node);
  {
    const std::lock_guard<std::mutex> lock(callback_groups_mutex_);
    callback_groups_.push_back(group);
  }
  detail::bump_entities_version();
  return group;
}

rclcpp::CallbackGroup::SharedPtr NodeBase::get_default_callback_group() {
  return default_callback_group_;
}

bool NodeBase::callback_group_in_node(rclcpp::CallbackGroup::SharedPtr group) {
  const std::lock_guard<std::mutex> lock(callback_groups_mutex_);
  return std::any_of(callback_groups_.begin(), callback_groups_.end(),
                     [&](const auto& weak) { return weak.lock() == group; });
}

void NodeBase::for_each_callback_group(const CallbackGroupFunction& func) {
  std::vector<rclcpp::CallbackGroup::SharedPtr> groups;
  {
    const std::lock_guard<std::mutex> lock(callback_groups_mutex_);
    for (const auto& weak : callback_groups_) {
      if (auto group = weak.lock()) {
        groups.push_back(std::move(group));
      }
    }
  }
  for (const auto& group : groups) {
    func(group);
  }
}

rclcpp::GuardCondition& NodeBase::get_notify_guard_condition() {
  return *notify_guard_condition_;
}

rclcpp::GuardCondition::SharedPtr NodeBase::get_shared_notify_guard_condition() {
  return notify_guard_condition_;
}

void NodeBase::trigger_notify_guard_condition() {
  notify_guard_condition_->trigger();
  detail::bump_entities_version();
}

std::string NodeBase::resolve_topic_or_service_name(const std::string& name, bool is_service,
                                                    bool only_expand) const {
  std::string full = expand_name(name, name_, namespace_, is_service);
  if (!only_expand) {
    full = ros2wasm::remap_topic_or_service(arguments_.get(), global_arguments_.get(), full,
                                            is_service, name_, namespace_);
  }
  if (const auto problem = ros2wasm::check_full_topic_name(full)) {
    refuse_name(full, *problem, is_service);
  }
  return full;
}

}  // namespace node_interfaces
}  // namespace rclcpp
