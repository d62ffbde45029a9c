// See spec_table.hpp.
#include "bundler/channel/spec_table.hpp"

#include <algorithm>

#include "workspace_schema/version.hpp"

namespace ros2wasm {
namespace {

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
}

}  // namespace

const Outcome<MatchSpec>& SpecTable::parsed(const std::string& text) {
  const auto known = parsed_.find(text);
  if (known != parsed_.end()) return known->second;
  return parsed_.emplace(text, MatchSpec::parse(text)).first->second;
}

std::optional<std::string> SpecTable::exact_name(const std::string& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_plain);
  // Nearly all texts are a name, then nothing or a space and more: no need to parse the rest.
  const bool url_or_path = text.find_first_of("/:*^") != std::string::npos;
  if (end != text.begin() && (end == text.end() || *end == ' ') && !url_or_path)
    return std::string(text.begin(), end);
  const auto& spec = parsed(text);
  return spec ? spec->exact_name() : std::nullopt;
}

const std::optional<std::string>& SpecTable::version_fault(const std::string& text) {
  const auto [known, fresh] = version_faults_.try_emplace(text);
  if (fresh) {
    const auto version = Version::parse(text);
    if (!version) known->second = version.errors().front().message;
  }
  return known->second;
}

}  // namespace ros2wasm
