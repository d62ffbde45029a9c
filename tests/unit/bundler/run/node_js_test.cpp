// Which Node.js is taken.
#include "bundler/run/node_js.hpp"

#include <gtest/gtest.h>

#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace {
namespace fs = std::filesystem;

TEST(NodeJsVersionTest, ReadsVersions) {
  EXPECT_EQ(node_js_version("v26.10.0\n"), (NodeJsVersion{.major = 26, .minor = 10}));
  EXPECT_EQ(node_js_version("v22.0.0-nightly"), (NodeJsVersion{.major = 22, .minor = 0}));
  for (const char* text : {"", "v", "26.1.0", "v26", "v26.1", "vx.1.1", "v.1.1"})
    EXPECT_EQ(node_js_version(text), std::nullopt) << text;
}

/// A folder with programs that only print a version.
class FindNodeJsTest : public ::testing::Test {
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
  const auto in_path = put("bin/node", "v22.13.0");
  const auto found =
      find_node_js(root() / "build/ros2wasm", "/nowhere:" + (root() / "bin").string(), {});
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(*found, in_path);
}

TEST_F(FindNodeJsTest, SaysWhatIsWrong) {
  const std::string path = (root() / "bin").string();
  const auto none = find_node_js(root() / "build/ros2wasm", path, {});
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.errors().front().code.text(), "R2W0620");
  for (const std::string version : {"20.19", "22.12"}) {  // the latter has no --permission
    put("bin/node", "v" + version + ".4");
    const auto old = find_node_js(root() / "build/ros2wasm", path, {});
    ASSERT_FALSE(old.ok());
    EXPECT_EQ(old.errors().front().code.text(), "R2W0620");
    EXPECT_NE(old.errors().front().why.front().find("version " + version), std::string::npos);
  }
  put("bin/node", "hello");
  EXPECT_FALSE(find_node_js(root() / "build/ros2wasm", path, {}).ok());
}

}  // namespace
}  // namespace ros2wasm
