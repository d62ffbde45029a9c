// See spec_channel.hpp.
#include "workspace_schema/conda/spec_channel.hpp"

#include <algorithm>
#include <vector>

namespace ros2wasm {
namespace {

/// All that is asked for but the channel.
auto other_fields(const MatchSpec& spec) {
  auto fields = spec.fields();
  std::erase_if(fields, [](const auto& field) { return field.first == "channel"; });
  return fields;
}

}  // namespace

Outcome<std::string> with_channel(const MatchSpec& spec, const std::string& channel) {
  const std::string& named = spec.channel()->text();
  std::string text = spec.text();
  // Brackets and parentheses are taken out of a text wherever they stand, also out of an address.
  if (const std::size_t place = text.find(named); place != std::string::npos) {
    text.replace(place, named.size(), channel);
    const auto now = MatchSpec::parse(text);
    if (now && now->channel() && now->channel()->exact() && now->channel()->text() == channel &&
        other_fields(*now) == other_fields(spec))
      return text;
  }
  const std::string& name = spec.name().text();
  return Diagnostic{
      .code = "R2W0303",
      .message = "the channel of `" + name + "` cannot be seen from its match spec",
      .why = {"its address has brackets or parentheses in it, or appears there twice"},
      .fix = {"write `" + name + "[channel=ADDRESS]`"}};
}

}  // namespace ros2wasm
