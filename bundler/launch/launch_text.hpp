// A text of a launch file with its substitutions, `$(name argument ...)`, as a tree. Pure.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct LaunchCall;
using LaunchPiece = std::variant<std::string, LaunchCall>;
/// Plain texts and substitutions, to be put together.
using LaunchText = std::vector<LaunchPiece>;

/// `$(name arguments)`. Arguments are separated by white space; quotes keep it.
struct LaunchCall {
  std::string name;
  std::vector<LaunchText> arguments;
};

/// Outside of substitutions quotes are plain text. A backslash takes the next character as it is.
/// R2W0411 with `span`, the place of the whole text.
[[nodiscard]] Outcome<LaunchText> parse_launch_text(std::string_view text, const SourceSpan& span);

}  // namespace ros2wasm
