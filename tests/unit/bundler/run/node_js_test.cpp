// Which Node.js is taken.
#include "bundler/run/node_js.hpp"

#include <gtest/gtest.h>

#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace {
namespace fs = std::filesystem;

TEST(NodeJsMajor, ReadsVersions) {
  EXPECT_EQ(node_js_major("v26.10.0\n"), 26);
  EXPECT_EQ(node_js_major("v22.0.0-nightly"), 22);
  for (const char* text : {"", "v", "26.1.0", "v26", "vx.1", "v.1"})
    EXPECT_EQ(node_js_major(text), std::nullopt) << text;
}

/// A folder with programs that only print a version.
class FindNodeJsTest : public testing::Test {
 protected:
  fs::path root() const { return folder_.value().path(); }
  fs::path put(const std::string& path, const std::string& version) {
    EXPECT_TRUE(write_file(root() / path, "#!/bin/sh\necho " + version + "\n").ok());
    fs::permissions(root() / path, fs::perms::owner_all);
    return root() / path;
  }

 private:
  Outcome<TemporaryDirectory> folder_ =
      TemporaryDirectory::make(fs::temp_directory_path(), "ros2wasm-node-");
};

TEST_F(FindNodeJsTest, PrefersThePinnedOne) {
  const auto pinned = put("node_modules/.bin/node", "v26.0.0");
  put("bin/node", "v30.0.0");
  const auto found =
      find_node_js(root() / "build/ros2wasm", (root() / "bin").string(), Cancellation());
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(*found, pinned);
}

TEST_F(FindNodeJsTest, TakesThePathsWhenNewEnough) {
  const auto in_path = put("bin/node", "v22.4.1");
  const auto found =
      find_node_js(root() / "build/ros2wasm", "/nowhere:" + (root() / "bin").string(), {});
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(*found, in_path);
}

TEST_F(FindNodeJsTest, SaysWhatIsWrong) {
  const std::string path = (root() / "bin").string();
  const auto none = find_node_js(root() / "build/ros2wasm", path, {});
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.errors().front().code, "R2W0620");
  put("bin/node", "v20.19.4");
  const auto old = find_node_js(root() / "build/ros2wasm", path, {});
  ASSERT_FALSE(old.ok());
  EXPECT_EQ(old.errors().front().code, "R2W0620");
  EXPECT_NE(old.errors().front().why.front().find("version 20"), std::string::npos);
  put("bin/node", "hello");
  EXPECT_FALSE(find_node_js(root() / "build/ros2wasm", path, {}).ok());
}

}  // namespace
}  // namespace ros2wasm
