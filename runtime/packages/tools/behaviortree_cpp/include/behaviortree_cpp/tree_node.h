// Base class of all nodes of a tree: a name, a state, ports, and subscribers to state changes.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "behaviortree_cpp/basic_types.h"
#include "behaviortree_cpp/blackboard.h"

namespace BT {

struct TreeNodeManifest {
  NodeType type = NodeType::UNDEFINED;
  std::string registration_ID;
  PortsList ports;
  KeyValueVector metadata;
  std::string description;
};

/// Port -> a value, or `{name}` of the blackboard.
using PortsRemapping = std::unordered_map<std::string, std::string>;

struct NodeConfig {
  Blackboard::Ptr blackboard;
  PortsRemapping input_ports;
  PortsRemapping output_ports;
  const TreeNodeManifest* manifest = nullptr;  ///< the factory's
  uint16_t uid = 0;
  std::string path;
};
using NodeConfiguration = NodeConfig;

class TreeNode {
 public:
  using Ptr = std::shared_ptr<TreeNode>;
  using StatusChangeCallback =
      std::function<void(TimePoint, const TreeNode&, NodeStatus before, NodeStatus now)>;
  /// Calls back as long as it is kept.
  using StatusChangeSubscriber = std::shared_ptr<StatusChangeCallback>;

  TreeNode(std::string name, NodeConfig config);
  virtual ~TreeNode() = default;
  TreeNode(const TreeNode&) = delete;
  TreeNode& operator=(const TreeNode&) = delete;

  /// Ticks, and keeps the state.
  virtual NodeStatus executeTick();
  /// Ends what runs, and goes back to IDLE.
  void haltNode();
  virtual void halt() = 0;
  [[nodiscard]] virtual NodeType type() const = 0;

  [[nodiscard]] NodeStatus status() const { return status_; }
  void setStatus(NodeStatus status);
  void resetStatus() { setStatus(NodeStatus::IDLE); }
  [[nodiscard]] bool isHalted() const { return status_ == NodeStatus::IDLE; }

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] uint16_t UID() const { return config_.uid; }
  [[nodiscard]] const std::string& fullPath() const { return config_.path; }
  [[nodiscard]] const std::string& registrationName() const { return registration_; }
  void setRegistrationID(StringView ID) { registration_ = ID; }
  [[nodiscard]] const NodeConfig& config() const { return config_; }
  [[nodiscard]] StatusChangeSubscriber subscribeToStatusChange(StatusChangeCallback callback);

  /// The value of a port: from the XML, from the blackboard, or its default.
  template <typename T>
  Result getInput(const std::string& key, T& destination) const {
    const auto value = input(key);
    if (!value) return nonstd::make_unexpected(value.error());
    try {
      destination = read_as<T>(*value);
    } catch (const std::exception& error) {
      return nonstd::make_unexpected(std::string(error.what()));
    }
    return std::monostate();
  }
  template <typename T>
  [[nodiscard]] Expected<T> getInput(const std::string& key) const {
    T value{};
    const Result done = getInput(key, value);
    if (!done) return nonstd::make_unexpected(done.error());
    return value;
  }
  template <typename T>
  Result setOutput(const std::string& key, const T& value) {
    const auto entry = output(key);
    if (!entry) return nonstd::make_unexpected(entry.error());
    config_.blackboard->set(*entry, value);
    return std::monostate();
  }
  [[nodiscard]] StringView getRawPortValue(const std::string& key) const;

  [[nodiscard]] static bool isBlackboardPointer(StringView text);
  /// The text between the braces.
  [[nodiscard]] static StringView stripBlackboardPointer(StringView text);

  void emitWakeUpSignal() {}
  [[nodiscard]] bool requiresWakeUp() const { return false; }

 protected:
  virtual NodeStatus tick() = 0;
  [[nodiscard]] NodeConfig& config() { return config_; }

 private:
  friend class BehaviorTreeFactory;

  [[nodiscard]] Expected<Any> input(const std::string& key) const;
  [[nodiscard]] Expected<std::string> output(const std::string& key) const;

  std::string name_;
  std::string registration_;
  NodeConfig config_;
  NodeStatus status_ = NodeStatus::IDLE;
  std::vector<std::weak_ptr<StatusChangeCallback>> listeners_;
};

}  // namespace BT
