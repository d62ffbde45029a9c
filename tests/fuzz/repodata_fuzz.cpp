// Any text as a repodata.json: records that can be trusted as names of files, or a reason.
#include "bundler/channel/channel_index.hpp"
#include "tests/fuzz/require.hpp"

using namespace ros2wasm;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto index = parse_repodata(fuzz::text_of(data, size), "channel", "noarch");
  if (!index) return 0;
  for (const PackageRecord& record : index->records) {
    fuzz::require(!record.name.empty() && !record.version.empty(), "a record has name and version");
    fuzz::require(record.file_name.find('/') == std::string::npos, "a file name is no path");
  }
  return 0;
}
