// Any bytes as a shard or a list of shards: records that can be trusted as names of files, or a
// reason. The bytes are MessagePack as it is inside of the compressed file, or, when they begin
// with zstd's magic number, the file itself: a fuzzer that had to find its way through the
// compression would see little of what lies behind it.
#include <string>

#include "bundler/archive/zstd.hpp"
#include "bundler/channel/shard_format.hpp"
#include "tests/fuzz/require.hpp"

using namespace ros2wasm;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  const bool packed = text.starts_with("\x28\xb5\x2f\xfd");
  const std::string bytes = packed ? std::string(text) : zstd_compressed(text, 1);
  if (const auto list = read_shard_list(bytes, "url")) {
    for (const auto& [name, hash] : list->shards) {
      const std::string sha256 = hash.hex();
      fuzz::require(
          sha256.size() == 64 && sha256.find_first_not_of("0123456789abcdef") == std::string::npos,
          "a shard's sha256 can be the name of its file");
    }
  }
  SpecTable specs;
  RepoIndex index;
  const RecordPlace place{.channel = "channel", .subdir = "noarch", .base_url = "channel/noarch"};
  if (!read_shard(bytes, "url", place, specs, index)) {
    fuzz::require(index.records.empty(), "what cannot be read gives no records");
    return 0;
  }
  for (const PackageRecord& record : index.records) {
    fuzz::require(!record.name.empty() && !record.version.empty(), "a record has name and version");
    fuzz::require(record.file_name.find('/') == std::string::npos, "a file name is not a path");
  }
  return 0;
}
