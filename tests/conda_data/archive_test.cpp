// The archives of the public mini channel: all are what they should be but two.
#include <algorithm>
#include <numeric>
#include <vector>

#include "bundler/archive/package_reader.hpp"
#include "conda_data/conda_data.hpp"
#include "unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

struct Defective {
  std::string file;
  std::vector<std::string> empty;  ///< links that came out as files without a byte
};

/// Each has the right sha256 itself.
const std::vector<Defective>& defective() {
  static const std::vector<Defective> rows{
      {.file = "linux-64/zlib-1.2.11-h7b6447c_3.tar.bz2",
       .empty = {"lib/libz.so", "lib/libz.so.1"}},
      {.file = "osx-64/zlib-1.2.11-h1de35cc_3.tar.bz2",
       .empty = {"lib/libz.1.dylib", "lib/libz.dylib"}}};
  return rows;
}

TEST(PublicArchives, WithEmptyFilesAreRefusedNamingThem) {
  for (const Defective& row : defective()) {
    const testing::TemporaryTree tree;
    const auto unpacked =
        unpack_package(testing::conda_data("mini_channel/" + row.file), tree.root(), "zlib", {});
    ASSERT_FALSE(unpacked.ok()) << row.file;
    const Diagnostic& error = unpacked.errors().front();
    EXPECT_EQ(error.code, "R2W0226");
    ASSERT_EQ(error.why.size(), row.empty.size() + 2);  // between what they are and that they were not kept
    for (const std::string& path : row.empty) {
      const std::string why = std::accumulate(error.why.begin(), error.why.end(), std::string());
      EXPECT_NE(why.find("`" + path + "` has 0 bytes"), std::string::npos) << why;
    }
  }
}

TEST(PublicArchives, TheOthersAreUnpacked) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(testing::conda_data("mini_channel"))) {
    const fs::path& file = entry.path();
    if (file.extension() != ".conda" && file.extension() != ".bz2") continue;
    if (std::any_of(defective().begin(), defective().end(),
                    [&](const Defective& row) { return file.string().ends_with(row.file); }))
      continue;
    const testing::TemporaryTree tree;
    const auto unpacked = unpack_package(file, tree.root(), "zlib", {});
    EXPECT_TRUE(unpacked.ok()) << file << ": "
                               << (unpacked.ok() ? "" : unpacked.errors().front().message);
    ++count;
  }
  EXPECT_EQ(count, 6U);
}

}  // namespace
}  // namespace ros2wasm
