// Any text as a repodata.json: records that can be trusted as names of files, or a reason. And the
// same places of records, however the text comes in pieces.
#include <optional>
#include <string>
#include <vector>

#include "bundler/channel/repodata_index.hpp"
#include "bundler/channel/repodata_scan.hpp"
#include "tests/fuzz/require.hpp"

using namespace ros2wasm;

namespace {

/// The results of a scan of these pieces; nothing when the text is refused.
std::optional<std::vector<std::string>> scanned(const std::vector<std::string_view>& pieces) {
  std::vector<std::string> found;
  RepodataScanner scanner([&found](const FoundRecord& record) {
    found.push_back(std::to_string(record.offset) + (record.conda ? "c" : "b"));
    found.back() += record.name;
    found.back() += record.text;
  });
  for (const std::string_view piece : pieces) {
    if (scanner.feed(piece)) return std::nullopt;
  }
  if (scanner.finish()) return std::nullopt;
  found.push_back(scanner.info());
  found.push_back(scanner.removed());
  return found;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  const std::size_t cut = size == 0 ? 0 : data[size / 2] * size / 256;
  fuzz::require(scanned({text}) == scanned({text.substr(0, cut), text.substr(cut)}),
                "pieces are read like the whole");
  const auto index = parse_repodata(text, "channel", "noarch");
  if (!index) return 0;
  for (const PackageRecord& record : index->records) {
    fuzz::require(!record.name.empty() && !record.version.empty(), "a record has name and version");
    fuzz::require(record.file_name.find('/') == std::string::npos, "a file name is not a path");
  }
  return 0;
}
