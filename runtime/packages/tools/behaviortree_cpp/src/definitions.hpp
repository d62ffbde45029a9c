// Trees as their XML tells them, and how a tree is made of that.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "behaviortree_cpp/bt_factory.h"
#include "ros2wasm_xml/xml_document.hpp"

namespace BT {

struct BehaviorTreeFactory::Definitions {
  using Document = std::shared_ptr<const ros2wasm_xml::XmlDocument>;
  struct Definition {
    Document document;
    const ros2wasm_xml::XmlElement* element = nullptr;  ///< the document's, `<BehaviorTree>`
    bool is_version_4 = false;
  };

  std::map<std::string, Definition> trees;
  /// That which the last text said to execute, or its only one; empty when it said neither.
  std::string main;

  /// Files that it includes are looked for in `folder`. Throws RuntimeError.
  void load(const std::string& text, const std::string& folder);
  void load_file(const std::string& path);
  int files_open = 0;  ///< each includes the next one
  [[nodiscard]] std::vector<std::string> names() const;
  [[nodiscard]] Tree tree(const BehaviorTreeFactory& factory, const std::string& name,
                          Blackboard::Ptr blackboard) const;
};

}  // namespace BT
