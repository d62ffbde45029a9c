// The code of a diagnostic: one that has a page in cli/explain/, or a program does not compile.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "workspace_schema/base/diagnostic_codes.hpp"

namespace ros2wasm {

// Clang 14, which compiles the launch evaluator, has bugs in `consteval`. The native build checks
// the same sources.
#if defined(__clang__) && __clang_major__ < 17
#define ROS2WASM_CHECKED_CODE constexpr
#else
#define ROS2WASM_CHECKED_CODE consteval
#endif

class DiagnosticCode {
 public:
  constexpr DiagnosticCode() = default;

  /// A literal.
  // NOLINTNEXTLINE(google-explicit-constructor): it stands for the code wherever one is asked for
  ROS2WASM_CHECKED_CODE DiagnosticCode(const char* literal) : text_(literal) {
    if (!has_page(text_)) throw "there is no page for this code in cli/explain/";
  }

  /// A code that another process of ros2wasm has written; empty when it has no page.
  [[nodiscard]] static DiagnosticCode of_text(std::string_view text) {
    DiagnosticCode code;
    const auto* found =
        std::lower_bound(std::begin(kDiagnosticCodes), std::end(kDiagnosticCodes), text);
    if (found != std::end(kDiagnosticCodes) && *found == text) code.text_ = *found;
    return code;
  }

  // NOLINTNEXTLINE(google-explicit-constructor)
  constexpr operator std::string_view() const { return text_; }
  [[nodiscard]] std::string text() const { return std::string(text_); }
  [[nodiscard]] constexpr bool empty() const { return text_.empty(); }
  [[nodiscard]] constexpr bool starts_with(std::string_view begin) const {
    return text_.starts_with(begin);
  }

  friend constexpr bool operator==(DiagnosticCode a, DiagnosticCode b) {
    return a.text_ == b.text_;
  }
  friend constexpr bool operator==(DiagnosticCode a, const char* b) { return a.text_ == b; }
  friend constexpr bool operator==(DiagnosticCode a, std::string_view b) { return a.text_ == b; }
  friend constexpr bool operator<(DiagnosticCode a, DiagnosticCode b) { return a.text_ < b.text_; }

  friend std::string operator+(std::string before, DiagnosticCode code) {
    return before.append(code.text_);
  }
  friend std::string operator+(DiagnosticCode code, std::string_view after) {
    return code.text().append(after);
  }

  template <typename Stream>
  friend Stream& operator<<(Stream& stream, DiagnosticCode code) {
    stream << code.text_;
    return stream;
  }

 private:
  static constexpr bool has_page(std::string_view text) {
    return std::binary_search(std::begin(kDiagnosticCodes), std::end(kDiagnosticCodes), text);
  }

  std::string_view text_;
};

}  // namespace ros2wasm
