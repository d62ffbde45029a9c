// See shipped_channel.hpp.
#include "bundler/plan/shipped_channel.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "bundler/channel/channel_index.hpp"
#include "bundler/channel/channel_writer.hpp"

namespace ros2wasm {

std::vector<ChannelFile> shipped_channel(const std::vector<PackageRecord>& records,
                                         const std::vector<StoredArchive>& archives) {
  // Both must be there, even empty (CEP 26).
  std::map<std::string, std::vector<PackageRecord>> subdirs{{"noarch", {}}, {kSitePlatform, {}}};
  std::vector<ChannelFile> files;
  const std::string root = std::string(kShippedChannel) + "/";
  for (std::size_t i = 0; i < records.size(); ++i) {
    const PackageRecord& record = records[i];
    const std::string subdir = record.subdir == "noarch" ? "noarch" : kSitePlatform;
    subdirs[subdir].push_back(record);
    files.push_back({.path = root + subdir + "/" + record.file_name,
                     .reason = "archive of " + record.name + ", for packing again",
                     .bytes = {},
                     .copy_of = archives[i].file,
                     .size = archives[i].size});
  }
  for (auto& [subdir, of_subdir] : subdirs) {
    std::sort(
        of_subdir.begin(), of_subdir.end(),
        [](const PackageRecord& a, const PackageRecord& b) { return a.file_name < b.file_name; });
    for (IndexPart& part : index_parts(subdir, of_subdir)) {
      const std::uint64_t size = part.bytes.size();
      files.push_back({.path = root + subdir + "/" + part.path,
                       .reason = "index of the channel, for packing again",
                       .bytes = std::move(part.bytes),
                       .copy_of = {},
                       .size = size});
    }
  }
  std::sort(files.begin(), files.end(),
            [](const ChannelFile& a, const ChannelFile& b) { return a.path < b.path; });
  return files;
}

}  // namespace ros2wasm
