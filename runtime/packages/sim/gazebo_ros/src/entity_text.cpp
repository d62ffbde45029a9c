// See entity_text.hpp.
#include "entity_text.hpp"

#include <algorithm>
#include <string_view>

#include "ros2wasm_xml/xml_document.hpp"

namespace gazebo_ros {

std::string fault_of_xml(const std::string& text) {
  try {
    const ros2wasm_xml::XmlDocument document(text);
    return {};
  } catch (const ros2wasm_xml::XmlError& error) {
    return error.reason() + ", line " + std::to_string(error.line());
  }
}

std::string database_entity(const std::string& name) {
  return "<sdf version='1.6'><world name='default'><include><uri>model://" + name +
         "</uri></include></world></sdf>";
}

std::string with_models_for_packages(const std::string& text) {
  constexpr std::string_view kScheme = "package://";
  std::string result = text;
  for (std::size_t at = result.find("<mesh"); at != std::string::npos;
       at = result.find("<mesh", at + 1)) {
    const std::size_t end = std::min(result.find('>', at), result.size());
    const std::size_t name = result.find("filename", at);
    if (name == std::string::npos || name > end) continue;
    const std::size_t begin = result.find_first_of("'\"", name);
    if (begin == std::string::npos || begin > end) continue;
    if (result.compare(begin + 1, kScheme.size(), kScheme) == 0)
      result.replace(begin + 1, kScheme.size(), "model://");
  }
  return result;
}

}  // namespace gazebo_ros
