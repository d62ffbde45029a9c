// Origins of web pages, as `site: embed:` lists them and as browsers write them. Pure.
#pragma once

#include <optional>
#include <string_view>

#include "workspace_schema/base/names.hpp"

namespace ros2wasm {

/// Nothing for `https://host`, `http://host:8080` in the one form that browsers compare with, and
/// for `*`, which is every page.
[[nodiscard]] std::optional<NameFault> page_origin_fault(std::string_view text);

}  // namespace ros2wasm
