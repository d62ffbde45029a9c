// See definitions.hpp.
#include "definitions.hpp"

#include <fstream>
#include <sstream>

namespace BT {
namespace {

using ros2wasm_xml::XmlDocument;
using ros2wasm_xml::XmlElement;

constexpr int kDeepest = 200;          ///< nodes within nodes and trees within trees
constexpr size_t kMostNodes = 10'000;  ///< a tree may be used many times within another one
constexpr int kMostOpenFiles = 20;

bool says_yes(const XmlElement& element, const char* attribute) {
  const std::string* value = element.attribute(attribute);
  return value != nullptr && convertFromString<bool>(*value);
}

const std::string& id_of(const XmlElement& element) {
  const std::string* ID = element.attribute("ID");
  if (ID == nullptr || ID->empty()) {
    throw RuntimeError("The tag <" + element.name + "> must have the attribute [ID]");
  }
  return *ID;
}

/// `<Action ID="Move"/>` is a Move, as `<Move/>` is.
bool is_kind(const std::string& tag) {
  return tag == "Action" || tag == "Condition" || tag == "Control" || tag == "Decorator";
}
bool is_subtree(const std::string& tag) {
  return tag == "SubTree" || tag == "SubTreePlus";
}

/// Makes the nodes of one tree, and of those that it uses.
class Builder {
 public:
  Builder(const BehaviorTreeFactory& factory, const BehaviorTreeFactory::Definitions& trees,
          Tree& tree)
      : factory_(factory), trees_(trees), tree_(tree) {
    tree_.manifests = factory.manifests();
  }

  /// The root of a tree, which has that blackboard.
  TreeNode* root(const std::string& tree_name, const Blackboard::Ptr& blackboard,
                 const std::string& path, int depth) {
    const auto found = trees_.trees.find(tree_name);
    if (found == trees_.trees.end()) {
      throw RuntimeError("Can't find a tree with name: " + tree_name);
    }
    const auto& definition = found->second;
    const auto children = definition.document->children(*definition.element);
    if (children.size() != 1) {
      throw RuntimeError("The tag <BehaviorTree> must have exactly 1 child: " + tree_name);
    }
    auto subtree = std::make_shared<Tree::Subtree>();
    subtree->blackboard = blackboard;
    subtree->instance_name = path;
    subtree->tree_ID = tree_name;
    tree_.subtrees.push_back(subtree);
    if (tree_.blackboard_stack.empty() || tree_.blackboard_stack.back() != blackboard) {
      tree_.blackboard_stack.push_back(blackboard);
    }
    return node(*children[0], {definition, blackboard, subtree}, path, depth + 1);
  }

 private:
  /// Where in the XML a node stands.
  struct Place {
    const BehaviorTreeFactory::Definitions::Definition& in;
    Blackboard::Ptr blackboard;
    Tree::Subtree::Ptr subtree;
  };

  TreeNode* node(const XmlElement& element, const Place& place, const std::string& path,
                 int depth) {
    if (depth > kDeepest) throw RuntimeError("the tree is too deep, or is a part of itself");
    if (tree_.nodes.size() >= kMostNodes) {
      throw RuntimeError("the tree has more than " + std::to_string(kMostNodes) + " nodes");
    }
    const std::string& ID = is_kind(element.name) ? id_of(element) : element.name;
    const auto manifest = tree_.manifests.find(ID);
    if (manifest == tree_.manifests.end()) throw RuntimeError("Node not recognized: " + ID);
    const bool uses_tree = is_subtree(element.name);
    const std::string* given = element.attribute("name");
    const std::string name = given != nullptr ? *given : uses_tree ? id_of(element) : ID;

    NodeConfig config;
    if (!uses_tree) config = ports(element, manifest->second);
    config.blackboard = place.blackboard;
    config.manifest = &manifest->second;
    config.uid = ++made_;
    config.path = path + (path.empty() ? "" : "/") + name + "::" + std::to_string(config.uid);
    const std::string own_path = config.path;
    const TreeNode::Ptr made = factory_.instantiateTreeNode(name, ID, config);
    tree_.nodes.push_back(made);
    place.subtree->nodes.push_back(made);

    const auto children = place.in.document->children(element);
    if (auto* control = dynamic_cast<ControlNode*>(made.get())) {
      if (children.empty())
        throw RuntimeError("A Control node must have at least 1 child: " + name);
      for (const XmlElement* child : children) {
        control->addChild(node(*child, place, own_path, depth + 1));
      }
    } else if (uses_tree) {
      auto* decorator = dynamic_cast<DecoratorNode*>(made.get());
      decorator->setChild(root(id_of(element), board(element, place), own_path, depth));
    } else if (auto* decorator = dynamic_cast<DecoratorNode*>(made.get())) {
      if (children.size() != 1) {
        throw RuntimeError("A Decorator node must have exactly 1 child: " + name);
      }
      decorator->setChild(node(*children[0], place, own_path, depth + 1));
    } else if (!children.empty()) {
      throw RuntimeError("Actions and conditions must not have any child: " + name);
    }
    return made.get();
  }

  /// The ports that its attributes set.
  static NodeConfig ports(const XmlElement& element, const TreeNodeManifest& manifest) {
    NodeConfig config;
    for (const auto& [key, value] : element.attributes) {
      if (key == "name" || key == "ID") continue;
      if (key[0] == '_') {
        throw RuntimeError("The attribute [" + key + "] of <" + element.name +
                           "> has a script, and scripts are not run here");
      }
      const auto port = manifest.ports.find(key);
      if (port == manifest.ports.end()) {
        throw RuntimeError("Possible typo? In the XML, you tried to remap port \"" + key +
                           "\" in node [" + manifest.registration_ID +
                           "], but the manifest/model of this node does not contain a port with "
                           "this name.");
      }
      const PortDirection direction = port->second.direction();
      if (direction != PortDirection::OUTPUT) config.input_ports[key] = value;
      if (direction != PortDirection::INPUT) config.output_ports[key] = value;
    }
    return config;
  }

  /// That of a subtree: its own, with the names that its attributes join to the parent's.
  static Blackboard::Ptr board(const XmlElement& element, const Place& place) {
    if (says_yes(element, "__shared_blackboard")) return place.blackboard;
    auto own = Blackboard::create(place.blackboard);
    own->enableAutoRemapping(says_yes(element, "_autoremap") || says_yes(element, "__autoremap"));
    for (const auto& [key, value] : element.attributes) {
      if (key == "name" || key == "ID" || key[0] == '_') continue;
      if (value == "{=}" || value == "=") {
        own->addSubtreeRemapping(key, key);
      } else if (TreeNode::isBlackboardPointer(value)) {
        own->addSubtreeRemapping(key, TreeNode::stripBlackboardPointer(value));
      } else if (place.in.is_version_4 || element.name == "SubTreePlus") {
        own->set(key, value);
      } else {
        own->addSubtreeRemapping(key, value);  // in version 3 without braces too
      }
    }
    return own;
  }

  const BehaviorTreeFactory& factory_;
  const BehaviorTreeFactory::Definitions& trees_;
  Tree& tree_;
  uint16_t made_ = 0;
};

}  // namespace

void BehaviorTreeFactory::Definitions::load(const std::string& text, const std::string& folder) {
  Document document;
  try {
    document = std::make_shared<XmlDocument>(text);
  } catch (const ros2wasm_xml::XmlError& error) {
    throw RuntimeError(std::string("Error parsing the XML: ") + error.what());
  }
  const XmlElement& root = document->root();
  if (root.name != "root") throw RuntimeError("The XML must have a root node called <root>");
  for (const XmlElement* other : document->children(root, "include")) {
    const std::string* path = other->attribute("path");
    if (path == nullptr || other->attribute("ros_pkg") != nullptr) {
      throw RuntimeError("<include> is read with the attribute [path] alone");
    }
    load_file(path->empty() || (*path)[0] == '/' ? *path : folder + *path);
  }
  const std::string* format = root.attribute("BTCPP_format");
  const auto found = document->children(root, "BehaviorTree");
  for (const XmlElement* element : found) {
    const std::string* ID = element->attribute("ID");
    if (ID == nullptr && found.size() != 1) {
      throw RuntimeError("The tag <BehaviorTree> must have the attribute [ID]");
    }
    trees[ID == nullptr ? "BehaviorTree" : *ID] = {document, element,
                                                   format != nullptr && *format == "4"};
  }
  if (const std::string* named = root.attribute("main_tree_to_execute")) {
    main = *named;
  } else if (found.size() == 1) {
    const std::string* ID = found[0]->attribute("ID");
    main = ID == nullptr ? "BehaviorTree" : *ID;
  }
}

void BehaviorTreeFactory::Definitions::load_file(const std::string& path) {
  if (files_open >= kMostOpenFiles) {
    throw RuntimeError("more than " + std::to_string(kMostOpenFiles) +
                       " files include one another, or one includes itself: " + path);
  }
  std::ifstream file(path);
  if (!file) throw RuntimeError("The file cannot be read: " + path);
  std::ostringstream text;
  text << file.rdbuf();
  ++files_open;
  try {
    load(text.str(), path.substr(0, path.find_last_of('/') + 1));
  } catch (...) {
    --files_open;
    throw;
  }
  --files_open;
}

std::vector<std::string> BehaviorTreeFactory::Definitions::names() const {
  std::vector<std::string> result;
  for (const auto& [name, definition] : trees) result.push_back(name);
  return result;
}

Tree BehaviorTreeFactory::Definitions::tree(const BehaviorTreeFactory& factory,
                                            const std::string& name,
                                            Blackboard::Ptr blackboard) const {
  if (name.empty()) {
    throw RuntimeError(
        "[main_tree_to_execute] was not specified correctly: the XML has more than one tree");
  }
  Tree tree;
  Builder(factory, *this, tree).root(name, blackboard, "", 0);
  return tree;
}

}  // namespace BT
