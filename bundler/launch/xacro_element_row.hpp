// What the parts of the walk share: the table of elements, and how content moves.
#pragma once

#include <cstdint>
#include <string_view>

#include "bundler/launch/xacro_expansion.hpp"

namespace ros2wasm {

struct XacroExpansion::Row {
  std::string_view tag;
  void (XacroExpansion::*expand)(const XmlNode& from, Scope scope, XmlNode& into);
};

/// The file of nodes that only mark where comments of the next element begin.
inline constexpr std::uint32_t kXacroMark = 0xFFFFFFFF;
inline constexpr std::size_t kMostOpenFiles = 64;

/// What is in `from`, with the prefixes that it declares, which stay valid.
void xacro_take_content(XmlNode& from, XmlNode& into);

}  // namespace ros2wasm
