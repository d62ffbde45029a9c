// Several steps' findings in one list.
#pragma once

#include <algorithm>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

inline void append(Diagnostics& to, const Diagnostics& more) {
  to.insert(to.end(), more.begin(), more.end());
}

[[nodiscard]] inline bool has_error(const Diagnostics& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Diagnostic& one) { return one.severity == Severity::kError; });
}

/// Those that have no place get this one.
inline void append(Diagnostics& to, Diagnostics more, const std::optional<SourceSpan>& place) {
  for (Diagnostic& one : more) {
    if (!one.span) one.span = place;
    to.push_back(std::move(one));
  }
}

}  // namespace ros2wasm
