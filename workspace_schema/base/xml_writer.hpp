// XML nodes as text. Pure.
#pragma once

#include <string>

#include "workspace_schema/base/xml_reader.hpp"

namespace ros2wasm {

/// The element with what is in it, indented, with a line of its own for each part. White space
/// alone is skipped, but for the only content of an element.
[[nodiscard]] std::string xml_text(const XmlNode& element);

}  // namespace ros2wasm
