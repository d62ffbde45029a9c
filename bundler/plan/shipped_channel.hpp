// The packages that a site was made from, as a conda channel beside it: `channel/<subdir>/` with
// their archives and an index. Whoever has it can pack the site again.
#pragma once

#include <vector>

#include "bundler/plan/plan_site.hpp"
#include "bundler/store/store.hpp"
#include "workspace_schema/conda/package_record.hpp"

namespace ros2wasm {

inline constexpr const char* kShippedChannel = "channel";

/// `archives[i]` is the archive of `records[i]`. The index says what `records` say, which may be
/// newer than what the archives say of themselves. Sorted by path. Pure.
[[nodiscard]] std::vector<ChannelFile> shipped_channel(const std::vector<PackageRecord>& records,
                                                       const std::vector<StoredArchive>& archives);

}  // namespace ros2wasm
