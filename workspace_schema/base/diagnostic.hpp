// A diagnostic is a value: what went wrong, where, why, and a way out.
// Nothing here prints; cli/console.cpp turns diagnostics into text or JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "workspace_schema/base/diagnostic_code.hpp"

namespace ros2wasm {

/// A place in a text file. `line` and `column` count from 1 (column in bytes of UTF-8);
/// 0 means unknown. `length` is the number of bytes that the caret line underlines.
struct SourceSpan {
  std::string file;
  std::uint32_t line = 0;
  std::uint32_t column = 0;
  std::uint32_t length = 0;
  std::string line_text;  ///< the whole source line, without its newline; empty when unknown

  bool operator==(const SourceSpan&) const = default;
};

enum class Severity { kError, kWarning, kNote };

/// The exit code a failed command ends with (see docs/errors.md).
enum class FailureKind : int {
  kUserInput = 1,    ///< manifest, sources, specs
  kCommandLine = 2,  ///< flags and arguments
  kEnvironment = 3,  ///< network, disk, missing tools
  kBug = 70,
  kInterrupted = 130,
};

/// The code of what compilers warn of: --quiet leaves it out.
inline constexpr DiagnosticCode kCompilerWarning = "R2W0525";

/// One finding.
struct Diagnostic {
  DiagnosticCode code;
  Severity severity = Severity::kError;
  FailureKind kind = FailureKind::kUserInput;
  std::string message;             ///< one line, in the user's words
  std::optional<SourceSpan> span;  ///< where, when it has a place
  std::string label;               ///< short text beside the caret, may be empty
  std::vector<std::string> why;    ///< deciding facts, one line each
  std::vector<std::string> fix;    ///< something to paste; only when proven
  std::string detail;              ///< verbatim tool output (compiler), may be empty
};

}  // namespace ros2wasm
