// Any text as a match spec: read or refused, given another channel, and matched in bounded time.
#include "tests/fuzz/require.hpp"
#include "workspace_schema/conda/match_spec.hpp"
#include "workspace_schema/conda/spec_channel.hpp"

using namespace ros2wasm;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  const auto spec = MatchSpec::parse(text.substr(0, text.find('\n')));
  if (!spec) return 0;
  const PackageRecord record{.name = "pkg",
                             .version = "1.2.3",
                             .build = "py39_0",
                             .subdir = "noarch",
                             .channel = "https://host/forge"};
  const bool first = spec->matches(record);
  fuzz::require(first == spec->matches(record), "the same question has the same answer");
  fuzz::require(!spec->fields().empty(), "a spec asks for something");
  if (spec->channel()) {
    const auto named = with_channel(*spec, record.channel);
    const auto again = named ? MatchSpec::parse(*named) : MatchSpec::parse("pkg");
    fuzz::require(again.ok() && again->accepts_channel(record.channel), "its channel is replaced");
  }
  return 0;
}
