// Shared by the parts of the walk: the table of elements, and a function that moves content.
#pragma once

#include <cstdint>
#include <string_view>

#include "bundler/launch/xacro/xacro_expansion.hpp"

namespace ros2wasm {

struct XacroExpansion::Row {
  std::string_view tag;
  void (XacroExpansion::*expand)(const XmlNode& from, Scope scope, XmlNode& into);
};

/// The file of nodes that only mark where comments of the next element begin.
inline constexpr std::uint32_t kXacroMark = 0xFFFFFFFF;
inline constexpr std::size_t kMostOpenFiles = 64;

/// Moves the content of `from` into `into`, with the namespace prefixes that it declares, which
/// stay valid.
void xacro_take_content(XmlNode& from, XmlNode& into);

}  // namespace ros2wasm
