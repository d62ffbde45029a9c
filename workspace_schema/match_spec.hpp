// Conda match specs (CEP 29): what a dependency asks for. Where the CEP's text and conda disagree, conda wins;
// the decisions are listed in docs/match-specs.md.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/outcome.hpp"
#include "workspace_schema/package_record.hpp"
#include "workspace_schema/version.hpp"

namespace ros2wasm {

/// An expression over versions: relations joined by `,` (and, binds tighter) and `|` (or), with parentheses.
class VersionSpec {
 public:
  VersionSpec();  ///< any version
  /// R2W0303 with the reason.
  [[nodiscard]] static Outcome<VersionSpec> parse(std::string_view text);

  [[nodiscard]] bool matches(const Version& version) const;
  [[nodiscard]] bool any() const;  ///< `*` or nothing
  [[nodiscard]] const std::string& text() const { return text_; }

  struct Node;  ///< in match_spec's own files

 private:
  std::string text_;
  std::shared_ptr<const Node> root_;
};

/// A pattern over a string field: `^regex$`, a glob with `*`, or the text itself (letter case does not count).
class TextPattern {
 public:
  [[nodiscard]] static Outcome<TextPattern> parse(std::string_view text);
  [[nodiscard]] bool matches(std::string_view value) const;
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] bool exact() const { return kind_ == Kind::kExact; }

 private:
  enum class Kind { kExact, kGlob, kRegex };
  std::string text_;
  Kind kind_ = Kind::kExact;
  std::shared_ptr<const void> regex_;
};

/// A number compared: `3`, `>=3`, `!=3`.
struct BuildNumberSpec {
  enum class Relation { kEqual, kNotEqual, kLess, kLessEqual, kGreater, kGreaterEqual };
  Relation relation = Relation::kEqual;
  std::uint64_t number = 0;
  [[nodiscard]] bool matches(std::uint64_t value) const;
};

class MatchSpec {
 public:
  /// R2W0303: what is wrong with the text. Letter case of names does not count.
  [[nodiscard]] static Outcome<MatchSpec> parse(std::string_view text);

  [[nodiscard]] const std::string& text() const { return text_; }  ///< as given
  /// The exact package name, lower case; nothing when the name is a pattern.
  [[nodiscard]] std::optional<std::string> exact_name() const;
  [[nodiscard]] const TextPattern& name() const { return name_; }
  [[nodiscard]] const std::optional<TextPattern>& channel() const { return channel_; }
  [[nodiscard]] const VersionSpec& version() const { return version_; }

  [[nodiscard]] bool matches(const PackageRecord& record, const Version& version) const;
  /// Parses the record's version; a record whose version does not parse matches nothing.
  [[nodiscard]] bool matches(const PackageRecord& record) const;

 private:
  std::string text_;
  TextPattern name_;
  VersionSpec version_;
  std::optional<TextPattern> channel_;
  std::optional<TextPattern> subdir_;
  std::optional<TextPattern> build_;
  std::optional<BuildNumberSpec> build_number_;
  std::optional<TextPattern> file_name_;
  std::optional<std::string> url_;
  std::optional<std::string> sha256_;
  std::optional<std::string> md5_;
  std::optional<TextPattern> license_;
  std::vector<std::string> track_features_;
};

}  // namespace ros2wasm
