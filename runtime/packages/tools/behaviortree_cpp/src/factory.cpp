// Classes of nodes by name, plugins, and trees that run; see bt_factory.h.
#include "behaviortree_cpp/bt_factory.h"

#include <iostream>
#include <map>
#include <thread>

#include "definitions.hpp"

namespace BT {
namespace {

/// File name of a library -> what it registers.
std::map<std::string, std::vector<impl::PluginFunction>>& plugins() {
  static std::map<std::string, std::vector<impl::PluginFunction>> all;
  return all;
}

}  // namespace

impl::PluginRegistration::PluginRegistration(const char* library, PluginFunction function) {
  plugins()[library].push_back(function);
}

BehaviorTreeFactory::BehaviorTreeFactory() : trees_(std::make_unique<Definitions>()) {
  for (const char* name : {"Sequence", "AsyncSequence"}) registerNodeType<SequenceNode>(name);
  for (const char* name : {"Fallback", "AsyncFallback"}) registerNodeType<FallbackNode>(name);
  for (const char* name : {"SequenceStar", "SequenceWithMemory"}) {
    registerNodeType<SequenceWithMemory>(name);
  }
  registerNodeType<ReactiveSequence>("ReactiveSequence");
  registerNodeType<ReactiveFallback>("ReactiveFallback");
  registerNodeType<ParallelNode>("Parallel");
  registerNodeType<IfThenElseNode>("IfThenElse");
  registerNodeType<WhileDoElseNode>("WhileDoElse");
  registerNodeType<SwitchNode<2>>("Switch2");
  registerNodeType<SwitchNode<3>>("Switch3");
  registerNodeType<SwitchNode<4>>("Switch4");
  registerNodeType<SwitchNode<5>>("Switch5");
  registerNodeType<SwitchNode<6>>("Switch6");
  registerNodeType<InverterNode>("Inverter");
  registerNodeType<ForceSuccessNode>("ForceSuccess");
  registerNodeType<ForceFailureNode>("ForceFailure");
  registerNodeType<KeepRunningUntilFailureNode>("KeepRunningUntilFailure");
  registerNodeType<RepeatNode>("Repeat");
  for (const char* name : {"RetryUntilSuccessful", "RetryUntilSuccesful"}) {
    registerNodeType<RetryNode>(name);
  }
  registerNodeType<DelayNode>("Delay");
  registerNodeType<TimeoutNode>("Timeout");
  registerNodeType<RunOnceNode>("RunOnce");
  for (const char* name : {"SubTree", "SubTreePlus"}) registerNodeType<SubTreeNode>(name);
  registerNodeType<SetBlackboardNode>("SetBlackboard");
  registerSimpleAction("AlwaysSuccess", [](TreeNode&) { return NodeStatus::SUCCESS; });
  registerSimpleAction("AlwaysFailure", [](TreeNode&) { return NodeStatus::FAILURE; });
  for (const auto& [name, builder] : builders_) builtin_.insert(name);
}
BehaviorTreeFactory::~BehaviorTreeFactory() = default;
BehaviorTreeFactory::BehaviorTreeFactory(BehaviorTreeFactory&&) noexcept = default;
BehaviorTreeFactory& BehaviorTreeFactory::operator=(BehaviorTreeFactory&&) noexcept = default;

void BehaviorTreeFactory::registerBuilder(const TreeNodeManifest& manifest,
                                          const NodeBuilder& builder) {
  if (!builders_.emplace(manifest.registration_ID, builder).second) {
    throw BehaviorTreeException("ID [" + manifest.registration_ID + "] already registered");
  }
  manifests_.emplace(manifest.registration_ID, manifest);
}

bool BehaviorTreeFactory::unregisterBuilder(const std::string& ID) {
  if (builtin_.count(ID) != 0) {
    throw LogicError("You can not remove the builtin registration ID [" + ID + "]");
  }
  manifests_.erase(ID);
  return builders_.erase(ID) != 0;
}

void BehaviorTreeFactory::registerSimpleAction(const std::string& ID,
                                               const SimpleActionNode::TickFunctor& functor,
                                               PortsList ports) {
  registerBuilder({NodeType::ACTION, ID, std::move(ports), {}, {}},
                  [functor](const std::string& name, const NodeConfig& config) {
                    return std::make_unique<SimpleActionNode>(name, functor, config);
                  });
}

void BehaviorTreeFactory::registerSimpleCondition(const std::string& ID,
                                                  const SimpleConditionNode::TickFunctor& functor,
                                                  PortsList ports) {
  registerBuilder({NodeType::CONDITION, ID, std::move(ports), {}, {}},
                  [functor](const std::string& name, const NodeConfig& config) {
                    return std::make_unique<SimpleConditionNode>(name, functor, config);
                  });
}

void BehaviorTreeFactory::registerSimpleDecorator(const std::string& ID,
                                                  const SimpleDecoratorNode::TickFunctor& functor,
                                                  PortsList ports) {
  registerBuilder({NodeType::DECORATOR, ID, std::move(ports), {}, {}},
                  [functor](const std::string& name, const NodeConfig& config) {
                    return std::make_unique<SimpleDecoratorNode>(name, functor, config);
                  });
}

void BehaviorTreeFactory::registerFromPlugin(const std::string& file_path) {
  const std::string file = file_path.substr(file_path.find_last_of('/') + 1);
  const auto found = plugins().find(file);
  if (found == plugins().end()) {
    throw RuntimeError("Could not load library: " + file_path +
                       " (a site has the libraries of nodes that the program was linked with)");
  }
  for (const impl::PluginFunction function : found->second) function(*this);
}

void BehaviorTreeFactory::registerBehaviorTreeFromFile(const std::string& filename) {
  trees_->load_file(filename);
}
void BehaviorTreeFactory::registerBehaviorTreeFromText(const std::string& xml_text) {
  trees_->load(xml_text, "");
}
std::vector<std::string> BehaviorTreeFactory::registeredBehaviorTrees() const {
  return trees_->names();
}
void BehaviorTreeFactory::clearRegisteredBehaviorTrees() {
  *trees_ = Definitions();
}

std::unique_ptr<TreeNode> BehaviorTreeFactory::instantiateTreeNode(const std::string& name,
                                                                   const std::string& ID,
                                                                   const NodeConfig& config) const {
  const auto builder = builders_.find(ID);
  if (builder == builders_.end()) {
    throw RuntimeError("BehaviorTreeFactory: ID [" + ID + "] not registered");
  }
  std::unique_ptr<TreeNode> node = builder->second(name, config);
  node->setRegistrationID(ID);
  node->config_ = config;
  return node;
}

Tree BehaviorTreeFactory::createTreeFromText(const std::string& text, Blackboard::Ptr blackboard) {
  Definitions with = *trees_;
  with.main.clear();
  with.load(text, "");
  return with.tree(*this, with.main, std::move(blackboard));
}

Tree BehaviorTreeFactory::createTreeFromFile(const std::string& file_path,
                                             Blackboard::Ptr blackboard) {
  Definitions with = *trees_;
  with.main.clear();
  with.load_file(file_path);
  return with.tree(*this, with.main, std::move(blackboard));
}

Tree BehaviorTreeFactory::createTree(const std::string& tree_name, Blackboard::Ptr blackboard) {
  return trees_->tree(*this, tree_name, std::move(blackboard));
}

void BehaviorTreeFactory::addDescriptionToManifest(const std::string& node_id,
                                                   const std::string& description) {
  const auto found = manifests_.find(node_id);
  if (found == manifests_.end()) {
    throw std::runtime_error("addDescriptionToManifest: wrong ID");
  }
  found->second.description = description;
}

// --- trees ------------------------------------------------------------------------------------

Tree::~Tree() {
  haltTree();
}

void Tree::haltTree() {
  if (nodes.empty()) return;
  rootNode()->haltNode();
}

Blackboard::Ptr Tree::rootBlackboard() const {
  return blackboard_stack.empty() ? nullptr : blackboard_stack.front();
}

NodeStatus Tree::tickOnce() {
  if (nodes.empty()) throw RuntimeError("Empty Tree");
  const NodeStatus answer = rootNode()->executeTick();
  if (isStatusCompleted(answer)) rootNode()->resetStatus();
  return answer;
}

NodeStatus Tree::tickWhileRunning(std::chrono::milliseconds sleep_time) {
  NodeStatus answer = tickOnce();
  while (answer == NodeStatus::IDLE || answer == NodeStatus::RUNNING) {
    sleep(sleep_time);
    answer = tickOnce();
  }
  return answer;
}

bool Tree::sleep(std::chrono::system_clock::duration timeout) {
  std::this_thread::sleep_for(timeout);
  return false;
}

void Tree::applyVisitor(const std::function<void(const TreeNode*)>& visitor) const {
  applyRecursiveVisitor(static_cast<const TreeNode*>(rootNode()), visitor);
}
void Tree::applyVisitor(const std::function<void(TreeNode*)>& visitor) {
  applyRecursiveVisitor(rootNode(), visitor);
}

}  // namespace BT
