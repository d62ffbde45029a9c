// Children: output, exit codes, a clean stop of a child and of what it started.
#include "bundler/io/process.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>

#include "bundler/build/source_hash.hpp"
#include "bundler/build/source_tree.hpp"
#include "bundler/io/installation.hpp"
#include "tests/unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

TEST(Process, CapturesBothStreamsAndTheExitCode) {
  const auto result =
      run_process({.arguments = {"sh", "-c", "echo out; echo err >&2; echo $WORD; exit 3"},
                   .environment = {{"WORD", "added"}},
                   .output_mode = OutputMode::kCapture},
                  {});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->output, "out\nadded\n");
  EXPECT_EQ(result->error, "err\n");
  EXPECT_EQ(result->exit_code, 3);
}

TEST(Process, TellsASignal) {
  const auto result = run_process({.arguments = {"sh", "-c", "kill -9 $$"}}, {});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->exit_code, 128 + SIGKILL);
}

TEST(Process, RunsInAFolder) {
  const testing::TemporaryTree tree;
  const auto result = run_process({.arguments = {"pwd"}, .directory = tree.root()}, {});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->output, std::filesystem::canonical(tree.root()).string() + "\n");
}

TEST(Process, AProgramThatIsNotThereIsAnError) {
  for (const char* name : {"no-such-program-here", "/no/such/file"}) {
    const auto result = run_process({.arguments = {name}}, {});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.errors().front().code.text(), "R2W0910");
  }
  const testing::TemporaryTree tree;
  const auto no_program = tree.write("broken",
                                     "\x7f"
                                     "ELF but not really");
  std::filesystem::permissions(no_program, std::filesystem::perms::owner_all);
  EXPECT_FALSE(run_process({.arguments = {no_program.string()}}, {}));
  EXPECT_FALSE(run_process({.arguments = {"true"}, .directory = "/no/such/folder"}, {}));
}

TEST(Process, AStopEndsTheChildAndItsChildren) {
  // Ctrl-C comes while the child waits for a grandchild; both must be gone when run_process
  // returns.
  std::array<int, 2> wake{};
  ASSERT_EQ(pipe(wake.data()), 0);
  std::atomic<bool> stop = false;
  std::string output;
  const auto result = run_process({.arguments = {"sh", "-c", "sleep 1000 & echo $!; wait"},
                                   .on_output =
                                       [&](std::string_view piece) {
                                         output += piece;
                                         if (!output.ends_with('\n')) return;
                                         stop = true;
                                         ASSERT_EQ(write(wake[1], "x", 1), 1);
                                       }},
                                  Cancellation(stop, wake[0]));
  close(wake[0]);
  close(wake[1]);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.errors().front().kind, FailureKind::kInterrupted);
  const pid_t grandchild = std::stoi(output);
  // It was told to end; wait until the system has taken it away (a zombie may linger until init
  // reaps it).
  const std::string state_file = "/proc/" + std::to_string(grandchild) + "/stat";
  bool gone = false;
  for (int i = 0; i < 500 && !gone; ++i) {
    const auto stat = run_process({.arguments = {"cat", state_file}}, {});
    gone = !stat || stat->exit_code != 0 || stat->output.find(") Z ") != std::string::npos;
  }
  EXPECT_TRUE(gone);
}

TEST(Process, AConfinedOneHasNoEnvironmentButItsOwn) {
  const auto result = run_process({.arguments = {"env"},
                                   .environment = {{"WORD", "given"}},
                                   .output_mode = OutputMode::kCapture,
                                   .is_confined = true},
                                  {});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->output, "WORD=given\n");
}

TEST(Process, AConfinedOneOpensNoSocket) {
  const std::string program = R"(
import socket
for family in (socket.AF_INET, socket.AF_INET6, socket.AF_UNIX):
    try:
        socket.socket(family)
        print("open")
    except PermissionError:
        print("refused")
)";
  const auto said = [&](bool is_confined) {
    const auto result = run_process({.arguments = {"python3", "-c", program},
                                     .output_mode = OutputMode::kCapture,
                                     .is_confined = is_confined},
                                    {});
    return result ? result->output : result.errors().front().message;
  };
  EXPECT_EQ(said(true), "refused\nrefused\nrefused\n");
  EXPECT_EQ(said(false).substr(0, 5), "open\n");
}

TEST(Process, EndsAtItsTimeLimit) {
  // The second has closed what is read from it.
  for (const char* text : {"echo begun; sleep 1000", "echo begun; exec >&- 2>&-; sleep 1000"}) {
    const auto result = run_process({.arguments = {"sh", "-c", text},
                                     .output_mode = OutputMode::kCapture,
                                     .time_limit = std::chrono::milliseconds(100)},
                                    {});
    ASSERT_TRUE(result);
    EXPECT_TRUE(result->is_out_of_time);
    EXPECT_EQ(result->output, "begun\n");
  }
  // A busy process ends by its processor time, long before the clock limit, which is ten times as
  // long.
  const auto begun = std::chrono::steady_clock::now();
  const auto busy = run_process({.arguments = {"sh", "-c", "while :; do :; done"},
                                 .output_mode = OutputMode::kCapture,
                                 .time_limit = std::chrono::milliseconds(700)},
                                {});
  ASSERT_TRUE(busy);
  EXPECT_TRUE(busy->is_out_of_time);
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(7));
  // Waiting, as on a busy machine, does not count as processor time.
  const auto slow = run_process({.arguments = {"sh", "-c", "sleep 2; echo done"},
                                 .output_mode = OutputMode::kCapture,
                                 .time_limit = std::chrono::milliseconds(1000)},
                                {});
  ASSERT_TRUE(slow);
  EXPECT_FALSE(slow->is_out_of_time);
  EXPECT_EQ(slow->output, "done\n");
  const auto quick = run_process({.arguments = {"sh", "-c", "echo done; exit 4"},
                                  .output_mode = OutputMode::kCapture,
                                  .time_limit = std::chrono::minutes(5)},
                                 {});
  ASSERT_TRUE(quick);
  EXPECT_FALSE(quick->is_out_of_time);
  EXPECT_EQ(quick->exit_code, 4);
}

TEST(FindProgram, LooksThroughThePath) {
  const testing::TemporaryTree tree;
  const auto file = tree.write("two/tool", "#!/bin/sh\n");
  tree.write("one/tool", "not executable");
  const std::string path = (tree / "one").string() + ":" + (tree / "two").string();
  EXPECT_FALSE(find_program("tool", path));
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  EXPECT_EQ(find_program("tool", path), file);
  EXPECT_FALSE(find_program("other", path));
  EXPECT_EQ(find_program(file.string()), file);
}

TEST(Installation, LooksBesideTheProgramAndInShare) {
  const testing::TemporaryTree tree;
  tree.write("build/templates/x", "");
  tree.write("usr/share/ros2wasm/templates/x", "");
  EXPECT_EQ(*find_own_data(tree / "build/ros2wasm", "templates/x", "it"),
            tree / "build/templates/x");
  EXPECT_EQ(*find_own_data(tree / "usr/bin/ros2wasm", "templates/x", "it"),
            tree / "usr/share/ros2wasm/templates/x");
  const auto missing = find_own_data(tree / "bin/ros2wasm", "templates/x", "the thing");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.errors().front().code.text(), "R2W0912");
  tree.write("node_modules/.bin/wasm-opt", "");
  EXPECT_EQ(find_npm_tool(tree / "build/ros2wasm", "wasm-opt"),
            tree / "node_modules/.bin/wasm-opt");
}

TEST(SourceHash, ContentsCountTimesAndHiddenFilesDoNot) {
  const testing::TemporaryTree tree;
  tree.write("a/x.cpp", "one");
  tree.write("a/sub/y.cpp", "two");
  const std::string before = *hash_of_tree(tree / "a");
  tree.write("a/x.cpp", "one");
  tree.write("a/.git/HEAD", "z");
  tree.write("a/__pycache__/m.pyc", "z");
  tree.write("a/site/site.json", R"({"generator":"ros2wasm 0.1.0"})");
  tree.write("a/build/COLCON_IGNORE", "");
  EXPECT_EQ(*hash_of_tree(tree / "a"), before);
  // A file of that name makes no site: it may be a source.
  tree.write("a/config/site.json", R"({"site":"of the robot"})");
  const std::string with_config = *hash_of_tree(tree / "a");
  EXPECT_NE(with_config, before);
  tree.write("a/config/a.yaml", "a: 1");
  EXPECT_NE(*hash_of_tree(tree / "a"), with_config);
  std::filesystem::remove_all(tree / "a/config");
  tree.write("a/sub/y.cpp", "2");
  EXPECT_NE(*hash_of_tree(tree / "a"), before);
  EXPECT_NE(HashBuilder().add("ab", "c").finish(), HashBuilder().add("a", "bc").finish());
}

TEST(SourceHash, WhatCannotBeReadHasNoHash) {
  const testing::TemporaryTree tree;
  EXPECT_EQ(hash_of_tree(tree / "gone").errors().front().code.text(), "R2W0210");
  // Listed as a file of many bytes, and refuses to be read, also by root.
  tree.write("a/x.cpp", "one");
  std::filesystem::create_symlink("/proc/self/mem", tree / "a/mem.bin");
  EXPECT_EQ(hash_of_tree(tree / "a").errors().front().code.text(), "R2W0210");
}

TEST(SourceTree, HasFoldersBeforeTheirFilesAndEachOnce) {
  const testing::TemporaryTree tree;
  tree.write("a/x.py", "");
  tree.write("a/sub/y.py", "");
  tree.write("a/.git/HEAD", "");
  tree.write("a/__pycache__/x.pyc", "");
  tree.write("a/install/COLCON_IGNORE", "");
  tree.write("a/site/site.json", R"({"generator":"ros2wasm 0.1.0"})");
  std::filesystem::create_directory_symlink("sub", tree / "a/again");
  std::filesystem::create_directory_symlink("..", tree / "a/sub/up");
  std::filesystem::create_symlink("nowhere", tree / "a/lost");
  const auto entries = source_tree(tree / "a");
  ASSERT_TRUE(entries);
  std::string text;
  for (const SourceEntry& one : *entries)
    text += one.path + (one.is_folder ? "/" : "") + (one.same_as.empty() ? "" : "=" + one.same_as) +
            " ";
  EXPECT_EQ(text, "./ again/ again/up/=. again/y.py sub/=again x.py ");
}

TEST(SourceTree, DoesNotWalkLinksOutOfTheWorkspace) {
  const testing::TemporaryTree tree;
  tree.write("w/a/x.py", "");
  tree.write("w/shared/y.py", "1");
  tree.write("elsewhere/z.py", "1");
  std::filesystem::create_directory_symlink("../shared", tree / "w/a/inside");
  std::filesystem::create_directory_symlink("../../elsewhere", tree / "w/a/out");
  const auto entries = source_tree(tree / "w/a", tree / "w");
  ASSERT_TRUE(entries);
  std::string text;
  for (const SourceEntry& one : *entries)
    text += one.path + (one.leads_to.empty() ? "" : "->" + one.leads_to) + " ";
  EXPECT_EQ(text, ". inside inside/y.py out->../../elsewhere x.py ");

  const std::string before = *hash_of_tree(tree / "w/a", tree / "w");
  tree.write("elsewhere/z.py", "2");
  EXPECT_EQ(*hash_of_tree(tree / "w/a", tree / "w"), before);
  tree.write("w/shared/y.py", "2");
  const std::string changed = *hash_of_tree(tree / "w/a", tree / "w");
  EXPECT_NE(changed, before);
  // By itself, the package has neither.
  EXPECT_NE(*hash_of_tree(tree / "w/a"), changed);
}

TEST(SourceHash, LinksOutOfTheWorkspaceCountWithWhatTheyLeadToWhereBuildsReadIt) {
  const testing::TemporaryTree tree;
  tree.write("w/a/x.cpp", "");
  tree.write("elsewhere/include/z.hpp", "1");
  std::filesystem::create_directory_symlink("../../elsewhere", tree / "w/a/out");
  const auto hash = [&] { return *hash_of_tree(tree / "w/a", tree / "w", LinksOut::kHashed); };
  const std::string before = hash();
  EXPECT_EQ(hash(), before);
  EXPECT_NE(*hash_of_tree(tree / "w/a", tree / "w"), before);
  tree.write("elsewhere/include/z.hpp", "2");
  const std::string changed = hash();
  EXPECT_NE(changed, before);
  tree.write("elsewhere/more.hpp", "");
  EXPECT_NE(hash(), changed);
  tree.write("elsewhere/include/z.hpp", "1");
  std::filesystem::remove(tree / "elsewhere/more.hpp");
  EXPECT_EQ(hash(), before) << "times do not count";

  // Past the bytes that are read, sizes and times stand for them.
  tree.write("elsewhere/large", "");
  std::filesystem::resize_file(tree / "elsewhere/large", 65'000'000);
  const std::string large = hash();
  EXPECT_EQ(hash(), large);
  std::filesystem::last_write_time(
      tree / "elsewhere/large",
      std::filesystem::file_time_type::clock::now() + std::chrono::hours(1));
  EXPECT_NE(hash(), large);
  // A folder that cannot be read does not fail a build.
  std::filesystem::create_directory_symlink("/proc/self", tree / "w/a/endless");
  EXPECT_FALSE(hash().empty());
}

TEST(SourceTree, EndsEarlyWhereItIsTold) {
  const testing::TemporaryTree tree;
  for (const char* name : {"a", "b/c", "b/d", "e"}) tree.write(name, "");
  EXPECT_EQ(source_tree(tree.root(), {}, 3)->size(), 3U);
}

TEST(SourceHash, LinksThatLeadRoundEndAndCount) {
  const testing::TemporaryTree tree;
  tree.write("a/x.cpp", "one");
  tree.write("a/sub/y.cpp", "two");
  std::filesystem::create_directory_symlink(".", tree / "a/one");
  const std::string one = *hash_of_tree(tree / "a");
  // Followed at every level, two such links would be as many names as there are binary numbers.
  std::filesystem::create_directory_symlink(".", tree / "a/two");
  const std::string two = *hash_of_tree(tree / "a");
  EXPECT_NE(two, one);
  std::filesystem::remove(tree / "a/two");
  std::filesystem::create_directory_symlink("sub", tree / "a/two");
  EXPECT_NE(*hash_of_tree(tree / "a"), two);
  tree.write("a/sub/y.cpp", "2");
  EXPECT_NE(*hash_of_tree(tree / "a"), two);
}

TEST(Conversation, LinesGoBothWays) {
  auto talk = Conversation::start(
      {.arguments = {"sh", "-c", "while read -r line; do echo \"got $line\"; done"},
       .environment = {},
       .directory = {},
       .on_output = {}},
      {});
  ASSERT_TRUE(talk.ok());
  EXPECT_EQ(*(*talk)->ask("one"), "got one");
  const std::string large(300'000, 'x');
  EXPECT_EQ(*(*talk)->ask(large), "got " + large);
}

TEST(Conversation, EndsWhenPatienceIsOver) {
  auto talk = Conversation::start({.arguments = {"sh", "-c", "while :; do sleep 1; done"},
                                   .environment = {},
                                   .directory = {},
                                   .on_output = {}},
                                  {});
  ASSERT_TRUE(talk.ok());
  const Patience little = (*talk)->patience(std::chrono::milliseconds(10));
  EXPECT_FALSE((*talk)->ask("one", little).ok());
  EXPECT_TRUE((*talk)->is_out_of_time());
}

TEST(Conversation, AProgramThatEndsIsTold) {
  auto talk = Conversation::start({.arguments = {"sh", "-c", "read -r line; echo oops >&2; exit 3"},
                                   .environment = {},
                                   .directory = {},
                                   .on_output = {}},
                                  {});
  ASSERT_TRUE(talk.ok());
  for (int i = 0; i < 2; ++i) {
    const auto answer = (*talk)->ask("one");
    ASSERT_FALSE(answer.ok());
    EXPECT_EQ(answer.errors()[0].code, "R2W0910");
    EXPECT_EQ(answer.errors()[0].detail, "oops\n");
  }
}

}  // namespace
}  // namespace ros2wasm
