// Explains a YAML syntax error in the words of the person who wrote the file. Looks at the text
// around the place for common mistakes: tabs, no space after a colon, a colon inside a value, an
// open quote, odd indentation. A fix is offered only when the text parses further with it. Pure.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "workspace_schema/base/diagnostic.hpp"
#include "workspace_schema/base/source_text.hpp"

namespace ros2wasm {

/// The error that the YAML library reported.
struct YamlSyntaxReport {
  std::string_view message;
  std::size_t offset = 0;  ///< where it gave up
};

/// Offset of the first syntax error of a text; std::string_view::npos when there is none.
using FirstYamlError = std::function<std::size_t(std::string_view text)>;

/// R2W0101.
[[nodiscard]] Diagnostic yaml_syntax_error(const SourceText& source, const YamlSyntaxReport& report,
                                           const FirstYamlError& first_error);

}  // namespace ros2wasm
