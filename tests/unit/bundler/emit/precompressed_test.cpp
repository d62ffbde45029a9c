// Compressed files beside those of a site: what is left alone, and which are said to be wrong.
#include "bundler/emit/precompressed.hpp"
#include "bundler/verify/compressed_forms.hpp"

#include <gtest/gtest.h>

#include "bundler/archive/brotli.hpp"
#include "bundler/archive/deflate.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "tests/unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {
namespace fs = std::filesystem;
using testing::TemporaryTree;

const std::string kText(5000, 'a');
const std::string kOther(3000, 'b');

std::string row(const std::string& path, const std::string& bytes) {
  return R"({"path": ")" + path + R"(", "size": )" + std::to_string(bytes.size()) +
         R"(, "sha256": ")" + sha256_hex(bytes) + R"(", "reason": "test"})";
}

bool none_taken(std::string_view) {
  return false;
}

/// A site of a text, and of a file that has the name of its compressed form.
void write_site(const fs::path& site) {
  ASSERT_TRUE(make_directories(site));
  ASSERT_TRUE(write_file(site / "map.txt", kText));
  ASSERT_TRUE(write_file(site / "map.txt.gz", kOther));
  ASSERT_TRUE(write_file(site / "site.json", R"({"generator": "ros2wasm 0.1.0", "files": [)" +
                                                 row("map.txt", kText) + "," +
                                                 row("map.txt.gz", kOther) + "]}"));
}

TEST(Precompressed, LeavesTheFilesOfASiteThatHaveItsNames) {
  const TemporaryTree tree;
  write_site(tree / "site");
  ASSERT_TRUE(precompress_site(tree / "site", {}));
  EXPECT_EQ(*read_file(tree / "site/map.txt.gz", kMostOfData), kOther);
  EXPECT_EQ(*brotli_unpacked(*read_file(tree / "site/map.txt.br", kMostOfData), kText.size(), "br"),
            kText);
  EXPECT_EQ(*gunzipped(*read_file(tree / "site/map.txt.gz.gz", kMostOfData), kOther.size(), "gz"),
            kOther);
  const std::set<fs::path> files{tree / "site/map.txt", tree / "site/map.txt.gz"};
  const std::string sum = sha256_hex(kText);
  EXPECT_FALSE(
      wrong_compressed(tree / "site/map.txt", kText.size(), sum, [&](std::string_view ending) {
        return files.contains(tree / ("site/map.txt" + std::string(ending)));
      }));
  EXPECT_EQ(wrong_compressed(tree / "site/map.txt", kText.size(), sum, none_taken), ".gz");
}

TEST(Precompressed, ALinkAFolderAndAnEndlessFileAreWrongAndNotRead) {
  const TemporaryTree tree;
  const fs::path file = tree / "map.txt";
  const fs::path form = tree / "map.txt.br";
  ASSERT_TRUE(write_file(file, kText));
  const std::string sum = sha256_hex(kText);
  const auto wrong = [&] { return wrong_compressed(file, kText.size(), sum, none_taken); };
  ASSERT_TRUE(write_file(form, brotli_compressed(kText)));
  EXPECT_FALSE(wrong());
  ASSERT_TRUE(write_file(form, brotli_compressed(kText) + "x"));
  EXPECT_EQ(wrong(), ".br");
  ASSERT_TRUE(write_file(form, brotli_compressed(kText + "a")));
  EXPECT_EQ(wrong(), ".br");
  fs::remove(form);
  fs::create_symlink("/dev/zero", form);
  EXPECT_EQ(wrong(), ".br");
  fs::remove(form);
  fs::create_directory(form);
  EXPECT_EQ(wrong(), ".br");
  fs::remove(form);
  ASSERT_TRUE(write_file(form, brotli_compressed(kText)));
  fs::resize_file(form, std::uint64_t{1} << 40U);  // sparse
  EXPECT_EQ(wrong(), ".br");
}

}  // namespace
}  // namespace ros2wasm
