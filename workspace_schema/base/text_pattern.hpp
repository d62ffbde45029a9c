// A pattern over a text field of a record: `^regex$`, a glob with `*`, or the text itself.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

enum class LetterCase { kCounts, kIgnored };

class TextPattern {
 public:
  TextPattern() = default;  ///< the empty text
  /// R2W0303 for a regular expression that cannot be read. Expressions are Python's, without
  /// look-around, references and flags and with small counts, so that matching time stays bounded.
  [[nodiscard]] static Outcome<TextPattern> parse(std::string_view text, LetterCase letter_case);

  [[nodiscard]] bool matches(std::string_view value) const;
  [[nodiscard]] bool exact() const { return kind_ == Kind::kExact; }
  [[nodiscard]] const std::string& text() const {
    return text_;
  }  ///< lower case when case is ignored

 private:
  enum class Kind { kExact, kGlob, kRegex };
  struct Regex;

  std::string text_;
  Kind kind_ = Kind::kExact;
  LetterCase letter_case_ = LetterCase::kCounts;
  std::shared_ptr<const Regex> regex_;
};

/// `*` stands for any run of characters; everything else for itself.
[[nodiscard]] bool glob_matches(std::string_view pattern, std::string_view value);

/// Letters A to Z as a to z.
[[nodiscard]] std::string ascii_lower(std::string_view text);

/// Each byte as two digits, in lower case.
[[nodiscard]] std::string hex_text(std::string_view bytes);

}  // namespace ros2wasm
