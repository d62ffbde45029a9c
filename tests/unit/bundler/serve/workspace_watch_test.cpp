// Which files of a workspace count, and when a change is settled.
#include "bundler/serve/workspace_watch.hpp"

#include <gtest/gtest.h>

#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace {
namespace fs = std::filesystem;

class WorkspaceMarksTest : public ::testing::Test {
 protected:
  void write(const std::string& path, const std::string& text) {
    ASSERT_TRUE(write_file(root() / path, text).ok());
  }
  fs::path root() const { return folder_.value().path(); }
  std::vector<std::string> seen() {
    std::vector<std::string> names;
    for (const auto& [path, mark] : workspace_marks({root()}, {root() / "site"}))
      names.push_back(fs::path(path).lexically_relative(root()).string());
    return names;
  }

 private:
  Outcome<TemporaryDirectory> folder_ =
      TemporaryDirectory::make(fs::temp_directory_path(), "ros2wasm-watch-");
};

TEST_F(WorkspaceMarksTest, LeaveOutWhatIsNotSource) {
  write("workspace.yaml", "a");
  write("src/demo/package.xml", "b");
  write("src/demo/log/notes.txt", "c");
  write(".git/index", "d");
  write("build/COLCON_IGNORE", "");
  write("build/demo/x.o", "e");
  write("site/index.html", "f");
  const std::vector<std::string> expected = {"src/demo/log/notes.txt", "src/demo/package.xml",
                                             "workspace.yaml"};
  EXPECT_EQ(seen(), expected);
}

TEST_F(WorkspaceMarksTest, FollowLinksToFoldersOnce) {
  write("outside/demo/a.cpp", "a");
  fs::create_directories(root() / "src");
  fs::create_directory_symlink(root() / "outside", root() / "src/linked");
  fs::create_directory_symlink(root(), root() / "src/loop");
  const std::vector<std::string> expected = {"outside/demo/a.cpp"};
  EXPECT_EQ(seen(), expected);
}

TEST_F(WorkspaceMarksTest, ChangeWithTheFile) {
  write("a.cpp", "one");
  const auto before = workspace_marks({root()}, {});
  EXPECT_EQ(workspace_marks({root()}, {}), before);
  write("a.cpp", "two");  // written beside and renamed: another inode, even within one tick
  EXPECT_NE(workspace_marks({root()}, {}), before);
}

TEST(WorkspaceWatch, WaitsUntilTheFilesAreStill) {
  const WorkspaceMarks first = {{"a", {.size = 1}}};
  const WorkspaceMarks second = {{"a", {.size = 2}}};
  const WorkspaceMarks third = {{"a", {.size = 2}}, {"b", {.size = 1}}};
  WorkspaceWatch watch(first);
  EXPECT_EQ(watch.look(first), std::nullopt);
  EXPECT_EQ(watch.look(second), std::nullopt);
  EXPECT_EQ(watch.look(third), std::nullopt);
  EXPECT_EQ(watch.look(third), "a");
  EXPECT_EQ(watch.look(third), std::nullopt);
}

TEST(WorkspaceWatch, SeesWhatIsNewAndWhatIsGone) {
  const WorkspaceMarks one = {{"a", {.size = 1}}};
  const WorkspaceMarks both = {{"a", {.size = 1}}, {"b", {.size = 1}}};
  WorkspaceWatch watch(one);
  (void)watch.look(both);
  EXPECT_EQ(watch.look(both), "b");
  (void)watch.look(one);
  EXPECT_EQ(watch.look(one), "b");
}

TEST(WorkspaceWatch, AcceptsWhatThePackWrote) {
  WorkspaceWatch watch({{"a", {.size = 1}}});
  watch.accept({{"lock", {.size = 5}}});
  const WorkspaceMarks now = {{"a", {.size = 1}}, {"lock", {.size = 5}}};
  EXPECT_EQ(watch.look(now), std::nullopt);
  EXPECT_EQ(watch.look(now), std::nullopt);
}

TEST(WorkspaceWatch, ForgetsAChangeThatWasTakenBack) {
  const WorkspaceMarks before = {{"a", {.size = 1}}};
  WorkspaceWatch watch(before);
  EXPECT_EQ(watch.look({{"a", {.size = 2}}}), std::nullopt);
  EXPECT_EQ(watch.look(before), std::nullopt);
  EXPECT_EQ(watch.look(before), std::nullopt);
}

}  // namespace
}  // namespace ros2wasm
