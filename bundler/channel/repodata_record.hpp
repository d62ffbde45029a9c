// One record of a repodata.json or an info/index.json, as a value. Accepts the many forms that real
// channels have.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "bundler/channel/raw_record.hpp"
#include "bundler/channel/spec_table.hpp"
#include "workspace_schema/conda/package_record.hpp"

namespace ros2wasm {

/// Where a record was found; goes into it. `base_url` is what the file name is put behind.
struct RecordPlace {
  std::string channel;
  std::string subdir;
  std::string base_url;
};

/// The record, or the reason why it cannot be used. Its specs are parsed through `specs`.
[[nodiscard]] std::variant<PackageRecord, std::string> parse_record(const RawRecord& raw,
                                                                    const std::string& file_name,
                                                                    const RecordPlace& place,
                                                                    SpecTable& specs);

}  // namespace ros2wasm
