// The public mini channel: the same flat and sharded, and its archives are indexed as it says.
#include <algorithm>

#include "bundler/channel/channel_index.hpp"
#include "bundler/channel/channel_writer.hpp"
#include "bundler/channel/repodata_index.hpp"
#include "bundler/resolve/solve.hpp"
#include "conda_data/conda_data.hpp"
#include "unit/bundler/support/temporary_tree.hpp"
#include "workspace_schema/schema/lock.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

/// The names that `./c` has for linux-64, and the lock of a request for `zlib`.
struct Answer {
  std::vector<std::string> names;
  std::string lock;
};

Answer answer_of(const testing::TemporaryTree& tree) {
  const ChannelRoots roots{.working_directory = tree.root(),
                           .embedded = {},
                           .cache = tree / "cache",
                           .network = {},
                           .platform = "linux-64"};
  const std::vector<ChannelSource> sources{{.name = "./c", .span = {}}};
  const auto index = load_channels(sources, roots);
  EXPECT_TRUE(index.ok());
  if (!index) return {};
  ResolveRequest request;
  request.specs.push_back({.text = "zlib", .origin = {}, .span = {}});
  auto resolution = solve(request, *index);
  EXPECT_TRUE(resolution.ok());
  if (!resolution) return {};
  std::sort(resolution->packages.begin(), resolution->packages.end(),
            [](const PackageRecord& a, const PackageRecord& b) { return a.name < b.name; });
  return {.names = index->names(),
          .lock = write_lock({.platform = roots.platform,
                              .channels = index->channels,
                              .specs = {"zlib"},
                              .packages = resolution->packages})};
}

TEST(PublicChannel, GivesTheSameLockFlatAndSharded) {
  const testing::TemporaryTree tree;
  fs::copy(testing::conda_data("mini_channel"), tree / "c", fs::copy_options::recursive);
  ASSERT_TRUE(fs::remove(tree / "c/linux-64/repodata.json"));  // so that only the shards are read
  const Answer sharded = answer_of(tree);
  fs::remove_all(tree / "c");
  fs::copy(testing::conda_data("mini_channel"), tree / "c", fs::copy_options::recursive);
  ASSERT_TRUE(fs::remove(tree / "c/linux-64/repodata_shards.msgpack.zst"));
  const Answer flat = answer_of(tree);
  EXPECT_EQ(flat.names, (std::vector<std::string>{"libgcc-ng", "zlib"}));
  EXPECT_EQ(sharded.names, flat.names);
  EXPECT_EQ(sharded.lock, flat.lock);
  EXPECT_NE(flat.lock.find("zlib-1.2.11-h7b6447c_3.conda"), std::string::npos) << flat.lock;
}

TEST(PublicChannel, ItsArchivesAreIndexedAsItSays) {
  const testing::TemporaryTree tree;
  fs::create_directories(tree / "c/win-64");
  for (const auto& entry : fs::directory_iterator(testing::conda_data("mini_channel/win-64"))) {
    if (entry.path().extension() == ".conda" || entry.path().extension() == ".bz2") {
      fs::copy_file(entry.path(), tree / "c/win-64" / entry.path().filename());
    }
  }
  ASSERT_TRUE(index_channel(tree / "c").ok());
  const auto ours = parse_repodata(tree.read("c/win-64/repodata.json"), "c", "win-64");
  const auto theirs =
      parse_repodata(testing::conda_text("mini_channel/win-64/repodata.json"), "c", "win-64");
  ASSERT_TRUE(ours.ok() && theirs.ok());
  ASSERT_FALSE(ours->records.empty());
  for (const PackageRecord& record : ours->records) {
    const auto twin = std::find_if(
        theirs->records.begin(), theirs->records.end(),
        [&](const PackageRecord& other) { return other.file_name == record.file_name; });
    ASSERT_NE(twin, theirs->records.end()) << record.file_name;
    EXPECT_EQ(record.sha256, twin->sha256);
    EXPECT_EQ(record.md5, twin->md5);
    EXPECT_EQ(record.size, twin->size);
    EXPECT_EQ(record.depends, twin->depends);
  }
}

}  // namespace
}  // namespace ros2wasm
