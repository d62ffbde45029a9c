// See descriptions.hpp.
#include "descriptions.hpp"

#include <string_view>

#include "ament_index_cpp/detail/file_text.hpp"
#include "ament_index_cpp/get_resource.hpp"
#include "ament_index_cpp/get_resources.hpp"
#include "pluginlib/exceptions.hpp"
#include "ros2wasm_xml/xml_document.hpp"

namespace pluginlib::impl {
namespace {

using ros2wasm_xml::XmlDocument;
using ros2wasm_xml::XmlElement;
using ros2wasm_xml::XmlError;

std::string attribute_or(const XmlElement& element, const std::string& key,
                         const std::string& otherwise) {
  const std::string* const value = element.attribute(key);
  return value == nullptr ? otherwise : *value;
}

const std::string& needed(const XmlElement& element, const std::string& key,
                          const std::string& text) {
  const std::string* const value = element.attribute(key);
  if (value == nullptr) {
    throw InvalidXMLException(text);
  }
  return *value;
}

/// `/opt/ros/jazzy/share/PACKAGE/plugins.xml`
std::string package_of(const std::string& path) {
  const std::string share = "/share/";
  const auto at = path.rfind(share);
  if (at == std::string::npos) {
    return {};
  }
  const auto from = at + share.size();
  return path.substr(from, path.find('/', from) - from);
}

void read_library(const XmlDocument& document, const XmlElement& library, const std::string& path,
                  std::vector<ClassDesc>& into) {
  const std::string name =
      needed(library, "path", "Attribute 'path' in 'library' tag is missing in " + path + ".");
  for (const XmlElement* const one : document.children(library, "class")) {
    const std::string derived = needed(
        *one, "type", "Class could not be loaded. Attribute 'type' in class tag is missing.");
    const std::string base =
        needed(*one, "base_class_type",
               "Class could not be loaded. Attribute 'base_class_type' in class tag is missing.");
    const XmlElement* const description = document.child(*one, "description");
    into.emplace_back(attribute_or(*one, "name", derived), derived, base, package_of(path),
                      description == nullptr ? "No 'description' tag for this plugin in plugin "
                                               "description file."
                                             : description->text,
                      name, path);
  }
}

}  // namespace

std::vector<std::string> description_paths(const std::string& package,
                                           const std::string& attribute) {
  const std::string kind = package + "__pluginlib__" + attribute;
  std::vector<std::string> paths;
  for (const auto& [of, prefix] : ament_index_cpp::get_resources(kind)) {
    std::string content;
    ament_index_cpp::get_resource(kind, of, content);
    for (std::string_view rest = content; !rest.empty();) {
      const size_t end = rest.find('\n');
      const std::string_view line = rest.substr(0, end);
      if (!line.empty()) {
        paths.push_back(prefix + "/" + std::string(line));
      }
      rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    }
  }
  return paths;
}

std::vector<ClassDesc> read_description(const std::string& path) {
  const std::string text = ament_index_cpp::detail::file_text(path).value_or("");
  try {
    const XmlDocument document(text);
    const XmlElement& root = document.root();
    std::vector<ClassDesc> classes;
    if (root.name == "library") {
      read_library(document, root, path, classes);
    } else if (root.name == "class_libraries") {
      for (const XmlElement* const library : document.children(root, "library")) {
        read_library(document, *library, path, classes);
      }
    } else {
      throw InvalidXMLException("The XML document '" + path +
                                "' given to add must have either \"library\" or "
                                "\"class_libraries\" as the root tag");
    }
    return classes;
  } catch (const XmlError&) {
    throw InvalidXMLException("XML Document '" + path +
                              "' has no Root Element. This likely means the XML is malformed or "
                              "missing.");
  }
}

}  // namespace pluginlib::impl
