// Makes trees of XML, from the classes of nodes that it was told of.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "behaviortree_cpp/behavior_tree.h"

namespace BT {

using NodeBuilder = std::function<std::unique_ptr<TreeNode>(const std::string&, const NodeConfig&)>;

template <typename T>
[[nodiscard]] constexpr NodeType getType() {
  if constexpr (std::is_base_of_v<ConditionNode, T>) return NodeType::CONDITION;
  if constexpr (std::is_base_of_v<ActionNodeBase, T>) return NodeType::ACTION;
  if constexpr (std::is_base_of_v<SubTreeNode, T>) return NodeType::SUBTREE;
  if constexpr (std::is_base_of_v<DecoratorNode, T>) return NodeType::DECORATOR;
  if constexpr (std::is_base_of_v<ControlNode, T>) return NodeType::CONTROL;
  return NodeType::UNDEFINED;
}

template <typename T, typename... Extra>
[[nodiscard]] NodeBuilder CreateBuilder(Extra... extra) {
  return [=](const std::string& name, const NodeConfig& config) -> std::unique_ptr<TreeNode> {
    if constexpr (std::is_constructible_v<T, const std::string&, const NodeConfig&, Extra...>) {
      return std::make_unique<T>(name, config, extra...);
    } else {
      return std::make_unique<T>(name, extra...);
    }
  };
}
template <typename T>
[[nodiscard]] TreeNodeManifest CreateManifest(const std::string& ID,
                                              PortsList ports = getProvidedPorts<T>()) {
  return {getType<T>(), ID, std::move(ports), {}, {}};
}

class Tree {
 public:
  struct Subtree {
    using Ptr = std::shared_ptr<Subtree>;
    std::vector<TreeNode::Ptr> nodes;
    Blackboard::Ptr blackboard;
    std::string instance_name;
    std::string tree_ID;
  };

  std::vector<TreeNode::Ptr> nodes;  ///< the root first
  std::vector<Subtree::Ptr> subtrees;
  std::vector<Blackboard::Ptr> blackboard_stack;
  std::unordered_map<std::string, TreeNodeManifest> manifests;

  Tree() = default;
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;
  Tree(Tree&&) = default;
  Tree& operator=(Tree&&) = default;
  ~Tree();

  void initialize() {}
  void haltTree();
  [[nodiscard]] TreeNode* rootNode() const { return nodes.empty() ? nullptr : nodes[0].get(); }
  [[nodiscard]] Blackboard::Ptr rootBlackboard() const;

  NodeStatus tickOnce();
  NodeStatus tickExactlyOnce() { return tickOnce(); }
  NodeStatus tickWhileRunning(std::chrono::milliseconds sleep_time = std::chrono::milliseconds(10));
  NodeStatus tickRoot() { return tickOnce(); }
  NodeStatus tickRootWhileRunning(
      std::chrono::milliseconds sleep_time = std::chrono::milliseconds(10)) {
    return tickWhileRunning(sleep_time);
  }
  /// False: nothing wakes it.
  bool sleep(std::chrono::system_clock::duration timeout);
  void emitWakeUpSignal() {}
  void applyVisitor(const std::function<void(const TreeNode*)>& visitor) const;
  void applyVisitor(const std::function<void(TreeNode*)>& visitor);
};

class BehaviorTreeFactory {
 public:
  struct Definitions;  ///< trees that were read, by name

  BehaviorTreeFactory();
  ~BehaviorTreeFactory();
  BehaviorTreeFactory(BehaviorTreeFactory&&) noexcept;
  BehaviorTreeFactory& operator=(BehaviorTreeFactory&&) noexcept;

  /// Throws BehaviorTreeException when the name is taken.
  void registerBuilder(const TreeNodeManifest& manifest, const NodeBuilder& builder);
  template <typename T>
  void registerBuilder(const std::string& ID, const NodeBuilder& builder) {
    registerBuilder(CreateManifest<T>(ID), builder);
  }
  /// False when there is none.
  bool unregisterBuilder(const std::string& ID);
  template <typename T, typename... Extra>
  void registerNodeType(const std::string& ID, const PortsList& ports, Extra... extra) {
    check_class<T, Extra...>();
    registerBuilder(CreateManifest<T>(ID, ports), CreateBuilder<T>(extra...));
  }
  template <typename T, typename... Extra>
  void registerNodeType(const std::string& ID, Extra... extra) {
    check_class<T, Extra...>();
    registerBuilder(CreateManifest<T>(ID), CreateBuilder<T>(extra...));
  }
  void registerSimpleAction(const std::string& ID, const SimpleActionNode::TickFunctor& functor,
                            PortsList ports = {});
  void registerSimpleCondition(const std::string& ID,
                               const SimpleConditionNode::TickFunctor& functor,
                               PortsList ports = {});
  void registerSimpleDecorator(const std::string& ID,
                               const SimpleDecoratorNode::TickFunctor& functor,
                               PortsList ports = {});
  /// A library that was linked into the program, by its file's name. Throws RuntimeError.
  void registerFromPlugin(const std::string& file_path);

  void registerBehaviorTreeFromFile(const std::string& filename);
  void registerBehaviorTreeFromText(const std::string& xml_text);
  [[nodiscard]] std::vector<std::string> registeredBehaviorTrees() const;
  void clearRegisteredBehaviorTrees();

  [[nodiscard]] std::unique_ptr<TreeNode> instantiateTreeNode(const std::string& name,
                                                              const std::string& ID,
                                                              const NodeConfig& config) const;
  [[nodiscard]] Tree createTreeFromText(const std::string& text,
                                        Blackboard::Ptr blackboard = Blackboard::create());
  [[nodiscard]] Tree createTreeFromFile(const std::string& file_path,
                                        Blackboard::Ptr blackboard = Blackboard::create());
  [[nodiscard]] Tree createTree(const std::string& tree_name,
                                Blackboard::Ptr blackboard = Blackboard::create());

  [[nodiscard]] const std::unordered_map<std::string, NodeBuilder>& builders() const {
    return builders_;
  }
  [[nodiscard]] const std::unordered_map<std::string, TreeNodeManifest>& manifests() const {
    return manifests_;
  }
  [[nodiscard]] const std::set<std::string>& builtinNodes() const { return builtin_; }
  void addDescriptionToManifest(const std::string& node_id, const std::string& description);

 private:
  template <typename T, typename... Extra>
  static constexpr void check_class() {
    static_assert(getType<T>() != NodeType::UNDEFINED,
                  "[registerNode]: accepts only classed derived from either ActionNodeBase, "
                  "DecoratorNode, ControlNode or ConditionNode");
    static_assert(!std::is_abstract_v<T>,
                  "[registerNode]: Some methods are pure virtual. Did you override the methods "
                  "tick() and halt()?");
    static_assert(std::is_constructible_v<T, const std::string&, Extra...> ||
                      std::is_constructible_v<T, const std::string&, const NodeConfig&, Extra...>,
                  "[registerNode]: the registered class must have at least one of these two "
                  "constructors: (const std::string&, const NodeConfig&) or (const std::string&)");
  }

  std::unordered_map<std::string, NodeBuilder> builders_;
  std::unordered_map<std::string, TreeNodeManifest> manifests_;
  std::set<std::string> builtin_;
  std::unique_ptr<Definitions> trees_;
};

namespace impl {

using PluginFunction = void (*)(BehaviorTreeFactory&);
/// Notes what a library registers, when the program starts.
struct PluginRegistration {
  PluginRegistration(const char* library, PluginFunction function);
};

}  // namespace impl
}  // namespace BT

/// Before a function's body that registers the nodes of a library; the build says the library's
/// name.
#ifdef BT_PLUGIN_LIBRARY
#define BT_REGISTER_NODES(factory)                                                               \
  static void BT_RegisterNodesFromPlugin(BT::BehaviorTreeFactory& factory);                      \
  static const BT::impl::PluginRegistration bt_plugin_registration(BT_PLUGIN_LIBRARY,            \
                                                                   &BT_RegisterNodesFromPlugin); \
  static void BT_RegisterNodesFromPlugin(BT::BehaviorTreeFactory& factory)
#else
#define BT_REGISTER_NODES(factory) \
  static void BT_RegisterNodesFromPlugin(BT::BehaviorTreeFactory& factory)
#endif
