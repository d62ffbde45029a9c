// Python expressions as launch files and xacro use them: numbers, texts, booleans, None, lists,
// tuples, dictionaries; operators, comparisons, `x if c else y`, indexing, slices, comprehensions;
// methods of texts; functions that the caller lets in. Nothing else can be reached. Pure.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "bundler/launch/python/python_value.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// How much work expressions may be, and how deep they may lead.
struct PythonLimits {
  std::int64_t steps_left = 1'000'000;
  int levels_left = 1000;
};

/// The names and limits that an expression can use.
struct PythonScope {
  std::function<std::optional<PythonValue>(const std::string& name)> name;
  PythonLimits* limits;  ///< of all expressions together
};

/// Throws PythonFault when it is no such expression, or fails.
[[nodiscard]] PythonValue python_evaluated(std::string_view expression, const PythonScope& scope);

/// The value as Python's str() writes it, with built-in functions and those of math, these also
/// by their bare names. R2W0411 with `span` when it is no such expression, or fails.
[[nodiscard]] Outcome<std::string> evaluate_python(std::string_view expression,
                                                   const SourceSpan& span);

}  // namespace ros2wasm
