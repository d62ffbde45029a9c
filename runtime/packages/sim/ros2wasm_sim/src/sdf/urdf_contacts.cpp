// See urdf_contacts.hpp.
#include "sdf/urdf_contacts.hpp"

#include <vector>

#include "sdf/sdf_link.hpp"
#include "sdf/xml_values.hpp"

namespace ros2wasm_sim {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    switch (letter) {
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '&':
        result += "&amp;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += letter;
    }
  }
  return result;
}

/// The text of an element, with other texts for some elements. It does not recurse, since elements
/// can be nested without a limit.
std::string written(const Node& root,
                    const std::unordered_map<const ros2wasm_xml::XmlElement*, std::string>& texts) {
  struct Open {
    Node node;
    bool is_end = false;
  };
  std::string result;
  std::vector<Open> open{{root, false}};
  while (!open.empty()) {
    const Open at = open.back();
    open.pop_back();
    const ros2wasm_xml::XmlElement& element = *at.node.element;
    if (at.is_end) {
      result += "</" + element.name + ">";
      continue;
    }
    result += "<" + element.name;
    for (const auto& [key, value] : element.attributes) {
      result += " " + key + "=\"" + escaped(value) + "\"";
    }
    const auto other = texts.find(&element);
    result += ">" + escaped(other == texts.end() ? element.text : other->second);
    open.push_back({at.node, true});
    const std::vector<Node> inner = children(at.node);
    for (auto one = inner.rbegin(); one != inner.rend(); ++one) {
      open.push_back({*one, false});
    }
  }
  return result;
}

}  // namespace

void rename_contacts(Context& context, const std::unordered_map<std::string, std::string>& renamed,
                     Sensor& sensor) {
  if (sensor.type != "contact" || renamed.empty()) {
    return;
  }
  const Source source{sensor.xml.document, "", "", Source().minor_version};
  const Node node{&source, sensor.xml.element};
  std::unordered_map<const ros2wasm_xml::XmlElement*, std::string> texts;
  for (const Node& contact : children(node, "contact")) {
    for (const Node& collision : children(contact, "collision")) {
      const auto found = renamed.find(text_of(collision));
      if (found != renamed.end()) {
        texts[collision.element] = found->second;
      }
    }
  }
  if (texts.empty()) {
    return;
  }
  const Source* changed = context.parse(written(node, texts), "", "");
  if (changed == nullptr) {
    return;
  }
  const Node root{changed, &changed->document->root()};
  sensor.xml = view_of(root);
  const std::vector<Node> plugins = children(root, "plugin");
  for (std::size_t i = 0; i < plugins.size() && i < sensor.plugins.size(); ++i) {
    sensor.plugins[i].xml = view_of(plugins[i]);
  }
}

}  // namespace ros2wasm_sim
