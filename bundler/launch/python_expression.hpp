// Python expressions as launch files use them in `$(eval ...)`: numbers, texts, booleans, None,
// lists; operators, comparisons, `x if c else y`, indexing; methods of texts; the built-in
// functions and those of `math` that make sense here. Nothing else can be reached. Pure.
#pragma once

#include <string>
#include <string_view>

#include "workspace_schema/outcome.hpp"

namespace ros2wasm {

/// The value as Python's str() writes it. R2W0411 with `span` when it is no such expression, or
/// fails.
[[nodiscard]] Outcome<std::string> evaluate_python(std::string_view expression,
                                                   const SourceSpan& span);

}  // namespace ros2wasm
