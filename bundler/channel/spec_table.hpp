// Match specs that were parsed already. Channels repeat the same few thousand texts a million
// times. Pure.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

#include "workspace_schema/match_spec.hpp"
#include "workspace_schema/outcome.hpp"

namespace ros2wasm {

class SpecTable {
 public:
  /// The spec, or what is wrong with the text. Valid as long as this table.
  const Outcome<MatchSpec>& parsed(const std::string& text);

 private:
  std::unordered_map<std::string, Outcome<MatchSpec>> parsed_;
};

}  // namespace ros2wasm
