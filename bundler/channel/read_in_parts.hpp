// Reads the records of many names on several threads. What comes out is the same as on one.
#pragma once

#include <functional>

#include "bundler/channel/channel_index.hpp"
#include "bundler/channel/spec_table.hpp"

namespace ros2wasm {

/// Adds what the names of these numbers have, from the first to before the last.
using ReadPart = std::function<Outcome<Done>(std::size_t first, std::size_t last, SpecTable& specs,
                                             RepoIndex& into)>;

/// `read` may run on several threads at once, each time with a table and an index of its own. A
/// table that checks is worth more when it is shared: then there is one part.
[[nodiscard]] Outcome<Done> read_in_parts(std::size_t count, SpecTable& specs, RepoIndex& into,
                                          const ReadPart& read);

}  // namespace ros2wasm
