// The code of all nodes and of blackboards; see tree_node.h and the headers beside it.
#include <iostream>

#include "behaviortree_cpp/behavior_tree.h"

namespace BT {
namespace {

/// Ends what runs, whatever it was.
void calm(TreeNode& node) {
  if (node.status() == NodeStatus::RUNNING) node.halt();
  node.resetStatus();
}

template <typename NodeT, typename VisitT>
void visit_all(NodeT* root, const VisitT& visit) {
  if (root == nullptr)
    throw LogicError("One of the children of a DecoratorNode or ControlNode is nullptr");
  visit(root);
  if (auto* control =
          dynamic_cast<std::conditional_t<std::is_const_v<NodeT>, const ControlNode, ControlNode>*>(
              root)) {
    for (NodeT* child : control->children()) visit_all(child, visit);
  } else if (auto* decorator = dynamic_cast<
                 std::conditional_t<std::is_const_v<NodeT>, const DecoratorNode, DecoratorNode>*>(
                 root)) {
    if (decorator->child() != nullptr) visit_all<NodeT>(decorator->child(), visit);
  }
}

}  // namespace

// --- blackboards ------------------------------------------------------------------------------

Blackboard::Ptr Blackboard::create(Ptr parent) {
  return Ptr(new Blackboard(std::move(parent)));
}

const std::string* Blackboard::name_above(const std::string& key) const {
  if (parent_ == nullptr) return nullptr;
  const auto found = names_above_.find(key);
  if (found != names_above_.end()) return &found->second;
  return takes_all_ && values_.count(key) == 0 && (key.empty() || key[0] != '_') ? &key : nullptr;
}

const Any* Blackboard::getAny(const std::string& key) const {
  if (const std::string* above = name_above(key)) return parent_->getAny(*above);
  const auto found = values_.find(key);
  return found == values_.end() ? nullptr : &found->second;
}

void Blackboard::put(const std::string& key, Any value) {
  const Lock lock = locked();
  if (const std::string* above = name_above(key)) {
    parent_->put(*above, std::move(value));
  } else {
    values_[key] = std::move(value);
  }
}

void Blackboard::unset(const std::string& key) {
  const Lock lock = locked();
  values_.erase(key);
}

void Blackboard::clear() {
  const Lock lock = locked();
  values_.clear();
}

std::vector<StringView> Blackboard::getKeys() const {
  const Lock lock = locked();
  std::vector<StringView> keys;
  for (const auto& [key, value] : values_) keys.emplace_back(key);
  return keys;
}

void Blackboard::debugMessage() const {
  const Lock lock = locked();
  for (const auto& [key, value] : values_) {
    std::cout << key << " (" << (value.empty() ? "empty" : demangle(value.type())) << ")\n";
  }
  for (const auto& [key, above] : names_above_) {
    std::cout << "[" << key << "] remapped to port of parent tree [" << above << "]\n";
  }
  std::cout.flush();
}

void Blackboard::addSubtreeRemapping(StringView internal, StringView external) {
  names_above_.emplace(internal, external);
}

// --- nodes ------------------------------------------------------------------------------------

TreeNode::TreeNode(std::string name, NodeConfig config)
    : name_(std::move(name)), config_(std::move(config)) {}

NodeStatus TreeNode::executeTick() {
  const NodeStatus answer = tick();
  if (answer != NodeStatus::SKIPPED) setStatus(answer);
  return answer;
}

void TreeNode::haltNode() {
  halt();
  resetStatus();
}

void TreeNode::setStatus(NodeStatus status) {
  if (status == status_) return;
  const NodeStatus before = std::exchange(status_, status);
  const TimePoint now = std::chrono::high_resolution_clock::now();
  for (const auto& listener : listeners_) {
    if (const auto callback = listener.lock()) (*callback)(now, *this, before, status);
  }
}

TreeNode::StatusChangeSubscriber TreeNode::subscribeToStatusChange(StatusChangeCallback callback) {
  auto kept = std::make_shared<StatusChangeCallback>(std::move(callback));
  listeners_.push_back(kept);
  return kept;
}

bool TreeNode::isBlackboardPointer(StringView text) {
  return text.size() >= 3 && text.front() == '{' && text.back() == '}';
}

StringView TreeNode::stripBlackboardPointer(StringView text) {
  return isBlackboardPointer(text) ? text.substr(1, text.size() - 2) : StringView();
}

StringView TreeNode::getRawPortValue(const std::string& key) const {
  for (const PortsRemapping* ports : {&config_.input_ports, &config_.output_ports}) {
    const auto found = ports->find(key);
    if (found != ports->end()) return found->second;
  }
  throw LogicError("[" + key + "] not found");
}

Expected<Any> TreeNode::input(const std::string& key) const {
  const std::string at = "getInput() of node '" + fullPath() + "' failed because ";
  Any value;
  if (const auto given = config_.input_ports.find(key); given != config_.input_ports.end()) {
    value = Any(given->second);
  } else if (config_.manifest != nullptr) {
    const auto port = config_.manifest->ports.find(key);
    if (port == config_.manifest->ports.end()) {
      return nonstd::make_unexpected(at + "the manifest doesn't contain the key: [" + key + "]");
    }
    value = port->second.defaultValue();
  }
  if (value.empty()) {
    return nonstd::make_unexpected(at + "nor the manifest or the XML contain the key: [" + key +
                                   "]");
  }
  if (!value.isString()) return value;
  const std::string text = value.cast<std::string>();
  if (text != "=" && !isBlackboardPointer(text)) return value;
  const std::string entry(text == "=" || text == "{=}" ? StringView(key)
                                                       : stripBlackboardPointer(text));
  Blackboard::Lock lock;
  if (config_.blackboard) lock = config_.blackboard->locked();
  const Any* found = config_.blackboard ? config_.blackboard->getAny(entry) : nullptr;
  if (found == nullptr || found->empty()) {
    return nonstd::make_unexpected("getInput() failed because it was unable to find the key [" +
                                   key + "] remapped to [" + entry + "]");
  }
  return *found;
}

Expected<std::string> TreeNode::output(const std::string& key) const {
  if (!config_.blackboard) {
    return nonstd::make_unexpected(std::string(
        "setOutput() failed: trying to access a Blackboard(BB) entry, but BB is invalid"));
  }
  std::string text;
  if (const auto given = config_.output_ports.find(key); given != config_.output_ports.end()) {
    text = given->second;
  } else if (config_.manifest != nullptr && config_.manifest->ports.count(key) != 0) {
    const Any& otherwise = config_.manifest->ports.at(key).defaultValue();
    if (otherwise.isString()) text = otherwise.cast<std::string>();
  }
  if (text.empty()) {
    return nonstd::make_unexpected(
        "setOutput() failed: NodeConfig::output_ports does not contain the key: [" + key + "]");
  }
  if (text == "=" || text == "{=}") return key;
  return std::string(isBlackboardPointer(text) ? stripBlackboardPointer(text) : StringView(text));
}

NodeStatus SyncActionNode::executeTick() {
  const NodeStatus answer = ActionNodeBase::executeTick();
  if (answer == NodeStatus::RUNNING) {
    throw LogicError("SyncActionNode MUST never return RUNNING");
  }
  return answer;
}

NodeStatus StatefulActionNode::tick() {
  if (status() == NodeStatus::IDLE) {
    is_halted_ = false;
    const NodeStatus answer = onStart();
    if (answer == NodeStatus::IDLE) {
      throw LogicError("StatefulActionNode::onStart() must not return IDLE");
    }
    return answer;
  }
  if (status() != NodeStatus::RUNNING) return status();
  const NodeStatus answer = onRunning();
  if (answer == NodeStatus::IDLE) {
    throw LogicError("StatefulActionNode::onRunning() must not return IDLE");
  }
  return answer;
}

void StatefulActionNode::halt() {
  is_halted_ = true;
  if (status() == NodeStatus::RUNNING) onHalted();
  resetStatus();
}

void ControlNode::halt() {
  resetChildren();
  resetStatus();
}

void ControlNode::haltChildren(std::size_t first) {
  for (std::size_t i = first; i < children_nodes_.size(); ++i) calm(*children_nodes_[i]);
}

void ControlNode::haltChild(std::size_t index) {
  calm(*children_nodes_.at(index));
}

void DecoratorNode::setChild(TreeNode* child) {
  if (child_node_ != nullptr) {
    throw BehaviorTreeException("Decorator [" + name() + "] has already a child assigned");
  }
  child_node_ = child;
}

void DecoratorNode::halt() {
  resetChild();
  resetStatus();
}

void DecoratorNode::resetChild() {
  if (child_node_ != nullptr) calm(*child_node_);
}

NodeStatus DecoratorNode::executeTick() {
  const NodeStatus answer = TreeNode::executeTick();
  if (child_node_ != nullptr && isStatusCompleted(child_node_->status()))
    child_node_->resetStatus();
  return answer;
}

// --- walks ------------------------------------------------------------------------------------

void applyRecursiveVisitor(const TreeNode* root,
                           const std::function<void(const TreeNode*)>& visit) {
  visit_all(root, visit);
}
void applyRecursiveVisitor(TreeNode* root, const std::function<void(TreeNode*)>& visit) {
  visit_all(root, visit);
}

void printTreeRecursively(const TreeNode* root, std::ostream& stream) {
  const std::function<void(const TreeNode*, std::size_t)> print = [&](const TreeNode* node,
                                                                      std::size_t depth) {
    stream << std::string(3 * depth, ' ') << node->name() << '\n';
    if (const auto* control = dynamic_cast<const ControlNode*>(node)) {
      for (const TreeNode* child : control->children()) print(child, depth + 1);
    } else if (const auto* decorator = dynamic_cast<const DecoratorNode*>(node)) {
      print(decorator->child(), depth + 1);
    }
  };
  stream << "----------------\n";
  print(root, 0);
  stream << "----------------" << std::endl;
}
void printTreeRecursively(const TreeNode* root) {
  printTreeRecursively(root, std::cout);
}

void buildSerializedStatusSnapshot(const TreeNode* root, SerializedTreeStatus& snapshot) {
  snapshot.clear();
  applyRecursiveVisitor(root, [&](const TreeNode* node) {
    snapshot.emplace_back(node->UID(), static_cast<uint8_t>(node->status()));
  });
}

}  // namespace BT
