// One subdirectory of one channel ("https://host/name/noarch"): which names it has, and the records
// of a name, read when asked for. One class per form of index: repodata.json, shards.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bundler/channel/channel_index.hpp"
#include "bundler/channel/spec_table.hpp"

namespace ros2wasm {

class SubdirIndex {
 public:
  SubdirIndex() = default;
  SubdirIndex(const SubdirIndex&) = delete;
  SubdirIndex& operator=(const SubdirIndex&) = delete;
  virtual ~SubdirIndex() = default;

  /// Every name that has a record here, sorted; lower case unless the channel is at fault. Valid as
  /// long as this object. Not needed to read records, so it may be made when it is asked for.
  [[nodiscard]] virtual std::span<const std::string_view> names() = 0;

  /// Adds the records of these names to `into`, sorted by file name within a name, and those that
  /// cannot be used to its `left_out`. Names that are not here are passed over. A caller asks for
  /// many names at once, so that an index which is fetched piece by piece can do so in parallel.
  [[nodiscard]] virtual Outcome<Done> read(std::span<const std::string> names, SpecTable& specs,
                                           RepoIndex& into, const Cancellation& cancellation) = 0;
};

}  // namespace ros2wasm
