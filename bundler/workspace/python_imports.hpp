// The imports of a Python file, as far as its text tells. Pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/diagnostic.hpp"

namespace ros2wasm {

/// `import a.b` or `from a.b import c, d`, one of each.
struct PythonImport {
  std::string module;  ///< "a.b"; of a relative one with its dots: "..b"
  std::vector<std::string> names;
  /// Names that the file uses of a module which it imports whole: `x` of `a.x`, after `import a`.
  /// Sorted.
  std::vector<std::string> attributes = {};
  bool needed = true;  ///< the file cannot be imported without it: not in a function, `try` or `if`
  SourceSpan span;
};

/// In the order of the file, which is only for messages.
[[nodiscard]] std::vector<PythonImport> python_imports(std::string_view text,
                                                       const std::string& file);

/// Does a file that begins so run as a Python script?
[[nodiscard]] bool is_python_script(std::string_view text);

/// Is it a module that Python itself brings, or has natively and lacks in a site?
[[nodiscard]] bool is_python_module(std::string_view top_level);
[[nodiscard]] bool is_lacking_python_module(std::string_view top_level);

}  // namespace ros2wasm
