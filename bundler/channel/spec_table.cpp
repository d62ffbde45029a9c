// See spec_table.hpp.
#include "bundler/channel/spec_table.hpp"

namespace ros2wasm {

const Outcome<MatchSpec>& SpecTable::parsed(const std::string& text) {
  const auto known = parsed_.find(text);
  if (known != parsed_.end()) return known->second;
  return parsed_.emplace(text, MatchSpec::parse(text)).first->second;
}

}  // namespace ros2wasm
