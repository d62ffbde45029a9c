// The command line for Node.js, and which file of the runtime it runs.
#include "bundler/run/headless_command.hpp"

#include <gtest/gtest.h>

#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace {
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

TEST(HeadlessCommand, HasOnlyWhatWasAsked) {
  EXPECT_EQ(headless_command("/n/node", "/r/headless.js", {.site = "site"}),
            (Words{"/n/node", "/r/headless.js", "site"}));
}

TEST(HeadlessCommand, PassesAllOptions) {
  EXPECT_EQ(headless_command("node", "headless.js",
                             {.site = "site",
                              .limit = std::chrono::milliseconds(1500),
                              .until = "I heard: .*",
                              .link = "port",
                              .stepped = true,
                              .seed = 7,
                              .trace = "sent.jsonl",
                              .bags = "kept",
                              .checks = true,
                              .junit = "checks.xml",
                              .json = true}),
            (Words{"node",    "headless.js", "site",    "--for",      "1500ms",
                   "--until", "I heard: .*", "--link",  "port",       "--stepped",
                   "--seed",  "7",           "--trace", "sent.jsonl", "--bags",
                   "kept",    "--checks",    "--junit", "checks.xml", "--json"}));
}

class FindHeadlessTest : public ::testing::Test {
 protected:
  fs::path root() const { return folder_.value().path(); }
  Outcome<fs::path> find_with(const std::string& list) {
    EXPECT_TRUE(write_file(root() / "runtime/runtime_assets.json", list).ok());
    return find_headless_program(root() / "ros2wasm");
  }

 private:
  Outcome<TemporaryDirectory> folder_ =
      TemporaryDirectory::make(fs::temp_directory_path(), "ros2wasm-headless-");
};

TEST_F(FindHeadlessTest, ReadsTheListOfTheRuntime) {
  const auto found = find_with(
      R"({"assets":[{"file":"a.js","role":"script"},{"file":"h.js","role":"headless"}]})");
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(*found, root() / "runtime/h.js");
}

TEST_F(FindHeadlessTest, FindsTheProgramOfEachRole) {
  ASSERT_TRUE(
      find_with(
          R"({"assets":[{"file":"h.js","role":"headless"},{"file":"r.js","role":"headless_ros2"}]})")
          .ok());
  const auto found = find_headless_program(root() / "ros2wasm", kRos2Role);
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(*found, root() / "runtime/r.js");
}

TEST_F(FindHeadlessTest, SaysWhatIsMissing) {
  EXPECT_EQ(find_headless_program(root() / "ros2wasm").errors().front().code.text(), "R2W0912");
  EXPECT_EQ(find_with(R"({"assets":[]})").errors().front().code.text(), "R2W0623");
  EXPECT_EQ(find_with("{}").errors().front().code.text(), "R2W0623");
  EXPECT_EQ(find_with("{").errors().front().code.text(), "R2W0604");
}

}  // namespace
}  // namespace ros2wasm
