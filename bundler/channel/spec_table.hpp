// Match specs and versions that were parsed already. Channels repeat the same few thousand texts a
// million times. Pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/conda/match_spec.hpp"

namespace ros2wasm {

/// The exact name in a match spec that is written in the plainest form, as nearly all are: the
/// name, then nothing or a space and more. Others must be parsed.
[[nodiscard]] std::optional<std::string_view> plain_name(std::string_view text);

class SpecTable {
 public:
  SpecTable() = default;
  /// With `checks` false, records are read without parsing their specs: the user of such a record
  /// parses the specs that it needs.
  explicit SpecTable(bool checks) : checks_(checks) {}
  [[nodiscard]] bool checks() const { return checks_; }

  /// The spec, or what is wrong with the text. Valid as long as this table.
  const Outcome<MatchSpec>& parsed(const std::string& text);

  /// The fault of the text as a version; nothing when it is a valid version. Valid as long as this
  /// table.
  const std::optional<std::string>& version_fault(const std::string& text);

 private:
  bool checks_ = true;
  std::unordered_map<std::string, Outcome<MatchSpec>> parsed_;
  std::unordered_map<std::string, std::optional<std::string>> version_faults_;
};

}  // namespace ros2wasm
