// The nodes of a factory as XML, for editors of trees.
#include <map>

#include "behaviortree_cpp/xml_parsing.h"

namespace BT {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
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

const char* element_of(PortDirection direction) {
  if (direction == PortDirection::INPUT) return "input_port";
  return direction == PortDirection::OUTPUT ? "output_port" : "inout_port";
}

void write_port(const std::string& name, const PortInfo& port, std::ostream& out) {
  const std::string element = element_of(port.direction());
  out << "            <" << element << " name=\"" << escaped(name) << '"';
  if (port.type() != typeid(AnyTypeAllowed)) out << " type=\"" << escaped(port.typeName()) << '"';
  if (const auto text = port.defaultValue().tryCast<std::string>();
      text && !port.defaultValue().empty())
    out << " default=\"" << escaped(*text) << '"';
  if (port.description().empty()) {
    out << "/>\n";
  } else {
    out << '>' << escaped(port.description()) << "</" << element << ">\n";
  }
}

}  // namespace

std::string writeTreeNodesModelXML(const BehaviorTreeFactory& factory, bool include_builtin) {
  std::ostringstream out;
  out << "<root BTCPP_format=\"4\">\n    <TreeNodesModel>\n";
  const auto& manifests = factory.manifests();
  for (const auto& [id, manifest] :
       std::map<std::string, TreeNodeManifest>(manifests.begin(), manifests.end())) {
    if (!include_builtin && factory.builtinNodes().count(id) != 0) continue;
    const std::string element = toStr(manifest.type);
    out << "        <" << element << " ID=\"" << escaped(id) << '"';
    if (manifest.ports.empty()) {
      out << "/>\n";
      continue;
    }
    out << ">\n";
    for (const auto& [name, port] :
         std::map<std::string, PortInfo>(manifest.ports.begin(), manifest.ports.end()))
      write_port(name, port, out);
    out << "        </" << element << ">\n";
  }
  out << "    </TreeNodesModel>\n</root>\n";
  return out.str();
}

}  // namespace BT
