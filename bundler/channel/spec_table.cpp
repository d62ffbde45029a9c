// See spec_table.hpp.
#include "bundler/channel/spec_table.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "workspace_schema/conda/version.hpp"

namespace ros2wasm {
namespace {

/// The characters of a name in its plainest form.
constexpr auto kPlain = [] {
  std::array<bool, 256> plain{};
  for (const char c : std::string_view("abcdefghijklmnopqrstuvwxyz0123456789-_."))
    plain.at(static_cast<unsigned char>(c)) = true;
  return plain;
}();

/// Characters after a name that can change its meaning: signs of a channel, an address, or members.
constexpr auto kRenaming = [] {
  std::array<bool, 256> renaming{};
  for (const char c : std::string_view(":/[(")) renaming.at(static_cast<unsigned char>(c)) = true;
  return renaming;
}();

}  // namespace

std::optional<std::string_view> plain_name(std::string_view text) {
  const auto is = [](const std::array<bool, 256>& which) {
    return [&which](char c) { return which[static_cast<unsigned char>(c)]; };
  };
  const auto* const end = std::find_if_not(text.begin(), text.end(), is(kPlain));
  if (end == text.begin() || (end != text.end() && *end != ' ')) return std::nullopt;
  if (std::any_of(end, text.end(), is(kRenaming))) return std::nullopt;
  return text.substr(0, static_cast<std::size_t>(end - text.begin()));
}

const Outcome<MatchSpec>& SpecTable::parsed(const std::string& text) {
  const auto known = parsed_.find(text);
  if (known != parsed_.end()) return known->second;
  return parsed_.emplace(text, MatchSpec::parse(text)).first->second;
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
