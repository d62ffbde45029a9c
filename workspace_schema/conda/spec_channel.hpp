// The channel in the text of a match spec. Pure.
#pragma once

#include <string>

#include "workspace_schema/conda/match_spec.hpp"

namespace ros2wasm {

/// The text of `spec`, which names a channel, with `channel` in its place. R2W0303 where it is not
/// in one piece in the text; that may hold credentials, so it is not shown.
[[nodiscard]] Outcome<std::string> with_channel(const MatchSpec& spec, const std::string& channel);

}  // namespace ros2wasm
