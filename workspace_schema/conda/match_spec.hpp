// Conda match specs (CEP 29): what a dependency asks for. Where the CEP's text and conda disagree,
// conda wins; the decisions are listed in docs/match-specs.md.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/base/text_pattern.hpp"
#include "workspace_schema/conda/package_record.hpp"
#include "workspace_schema/conda/version.hpp"
#include "workspace_schema/conda/version_spec.hpp"

namespace ros2wasm {

class MatchSpec {
 public:
  /// R2W0303: what is wrong with the text. Letter case of names does not count.
  [[nodiscard]] static Outcome<MatchSpec> parse(std::string_view text);

  [[nodiscard]] const std::string& text() const { return text_; }  ///< as given
  /// The exact package name, lower case; nothing when the name is a pattern.
  [[nodiscard]] std::optional<std::string> exact_name() const;
  [[nodiscard]] const TextPattern& name() const { return name_; }
  [[nodiscard]] const std::optional<TextPattern>& channel() const { return channel_; }
  /// Whether a record of a channel of this address may match.
  [[nodiscard]] bool accepts_channel(const std::string& address) const;
  [[nodiscard]] const VersionSpec& version() const { return version_; }
  [[nodiscard]] const std::optional<TextPattern>& build() const { return build_; }
  [[nodiscard]] const std::string& subdir() const { return subdir_; }  ///< empty: any

  /// All that is asked for, under conda's names of the fields.
  [[nodiscard]] std::vector<std::pair<std::string_view, std::string>> fields() const;

  [[nodiscard]] bool matches(const PackageRecord& record, const Version& version) const;
  /// Only what the spec says of versions, builds and build numbers.
  [[nodiscard]] bool matches_build(const Version& version, std::string_view build,
                                   std::uint64_t build_number) const;
  /// Parses the record's version; a record whose version does not parse matches nothing.
  [[nodiscard]] bool matches(const PackageRecord& record) const;

 private:
  friend class MatchSpecReader;

  std::string text_;
  TextPattern name_;
  VersionSpec version_;
  std::optional<TextPattern> channel_;
  std::optional<TextPattern> build_;
  std::optional<VersionSpec> build_number_;       ///< conda compares numbers as versions
  std::optional<TextPattern> build_number_text_;  ///< a regular expression over its digits
  bool no_build_number_ = false;                  ///< asks for a number that is none
  std::optional<TextPattern> license_;
  std::optional<std::vector<std::string>> track_features_;  ///< sorted; must be the same
  std::string subdir_;                                      ///< these are empty when not asked for
  std::string file_name_;
  std::string url_;
  std::string sha256_;
  std::string md5_;
  bool impossible_ = false;  ///< asks for a field that records here never have
};

}  // namespace ros2wasm
