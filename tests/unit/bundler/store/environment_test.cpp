// Environments: all files of all packages in one prefix, made once.
#include "bundler/store/environment.hpp"

#include <gtest/gtest.h>

#include "bundler/store/prefix_text.hpp"
#include "bundler/store/python_packages.hpp"
#include "unit/bundler/support/small_channel.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Environment, HasAllFilesAndIsMadeOnce) {
  testing::SmallChannel channel;
  channel.add("a", "1.0", {{"include/a.h", "a"}, {"share/ament_index/a", ""}});
  channel.add("b", "1.0", {{"include/b.h", "b"}});
  channel.write_index();
  const std::vector<PackageRecord> records{channel.record("a"), channel.record("b")};
  const auto first = make_environment(channel.store(), records);
  ASSERT_TRUE(first.ok());
  EXPECT_FALSE(first->cached);
  EXPECT_EQ(text_of(first->prefix / "include/a.h"), "a");
  EXPECT_EQ(text_of(first->prefix / "include/b.h"), "b");
  EXPECT_FALSE(fs::exists(first->prefix / "info"));
  EXPECT_EQ(fs::hard_link_count(first->prefix / "include/a.h"), 2U);
  const auto second = make_environment(channel.store(), records);
  ASSERT_TRUE(second.ok());
  EXPECT_TRUE(second->cached);
  EXPECT_EQ(second->prefix, first->prefix);
  EXPECT_EQ(second->key, environment_key(records));
  EXPECT_NE(environment_key({records[0]}), environment_key(records));
  EXPECT_TRUE(fs::is_empty(channel.tree() / "cache/environments/unfinished"));
}

TEST(Environment, AHalfWrittenOneIsMadeAgain) {
  testing::SmallChannel channel;
  channel.add("a", "1.0", {{"include/a.h", "a"}, {"include/b.h", "b"}});
  channel.write_index();
  const std::vector<PackageRecord> records{channel.record("a")};
  const auto first = make_environment(channel.store(), records);
  ASSERT_TRUE(first.ok());
  // As a copy that was cut off leaves it: some of the files, and not what is written last.
  fs::remove_all(first->prefix);
  fs::create_directories(first->prefix / "include");
  std::ofstream(first->prefix / "include/a.h") << "a";
  const auto again = make_environment(channel.store(), records);
  ASSERT_TRUE(again.ok());
  EXPECT_FALSE(again->cached);
  EXPECT_EQ(text_of(again->prefix / "include/b.h"), "b");
  EXPECT_TRUE(make_environment(channel.store(), records)->cached);
}

TEST(Environment, PlaceholdersBecomeThePrefix) {
  testing::SmallChannel channel;
  channel.add("a", "1.0", {{"lib/a.cmake", "set(P /old/place/lib;/old/place)"}, {"lib/plain", "x"}},
              {}, "/old/place");
  channel.write_index();
  const auto environment = make_environment(channel.store(), {channel.record("a")});
  ASSERT_TRUE(environment.ok());
  const std::string prefix = environment->prefix.string();
  EXPECT_EQ(text_of(environment->prefix / "lib/a.cmake"),
            "set(P " + prefix + "/lib;" + prefix + ")");
  // The store keeps the bytes of the archive.
  EXPECT_TRUE(channel.store().unpacked(channel.record("a")).ok());
}

TEST(Environment, LaterPackagesWinAndItIsReported) {
  testing::SmallChannel channel;
  channel.add("a", "1.0", {{"share/x", "from a"}, {"share/same", "same"}});
  channel.add("b", "1.0", {{"share/x", "from b"}, {"share/same", "same"}});
  channel.write_index();
  const auto environment =
      make_environment(channel.store(), {channel.record("a"), channel.record("b")});
  ASSERT_TRUE(environment.ok());
  EXPECT_EQ(text_of(environment->prefix / "share/x"), "from b");
  ASSERT_EQ(environment->overwritten.size(), 1U);
  EXPECT_EQ(environment->overwritten[0].path, "share/x");
  EXPECT_EQ(environment->overwritten[0].winner, "b-1.0-h_0");
}

TEST(Environment, AFailureLeavesNothing) {
  testing::SmallChannel channel;
  const fs::path archive = channel.add("a", "1.0", {{"x", "x"}});
  channel.write_index();
  const PackageRecord record = channel.record("a");
  fs::remove(archive);
  EXPECT_FALSE(make_environment(channel.store(), {record}).ok());
  EXPECT_TRUE(fs::is_empty(channel.tree() / "cache/environments/unfinished"));
}

TEST(Environment, NothingIsWrittenThroughAnotherPackagesLink) {
  testing::SmallChannel channel;
  // Each link stays inside its own package; together they would lead out of the prefix.
  channel.add_links("a", {{"d/deep/e", "../.."}});
  channel.add_links("b", {{"d/deep/e/f/g/l", "../../../../.."}});
  channel.add("c", "1.0", {{"d/deep/e/f/g/l/ESCAPED", "c"}});
  channel.add("d", "1.0", {{"d/deep/other", "d"}});
  channel.write_index();
  const PackageRecord a = channel.record("a");
  const auto both = make_environment(channel.store(), {a, channel.record("b")});
  ASSERT_FALSE(both.ok());
  EXPECT_EQ(both.errors().front().code.text(), "R2W0231");
  EXPECT_EQ(both.errors().front().message,
            "`b-1.0-h_0` and `a-1.0-h_0` cannot be installed together");
  const auto all = make_environment(channel.store(), {a, channel.record("b"), channel.record("c")});
  ASSERT_FALSE(all.ok());
  EXPECT_FALSE(fs::exists(channel.tree() / "cache/environments/ESCAPED"));
  const auto good = make_environment(channel.store(), {a, channel.record("d")});
  ASSERT_TRUE(good.ok());
  EXPECT_EQ(text_of(good->prefix / "d/deep/other"), "d");
  EXPECT_EQ(fs::read_symlink(good->prefix / "d/deep/e"), "../..");
}

TEST(Environment, AFileAndAFolderAreNotTheSameInEitherOrder) {
  testing::SmallChannel channel;
  channel.add("a", "1.0", {{"lib/foo/x", "x"}});
  channel.add("b", "1.0", {{"lib/foo", "y"}});
  channel.write_index();
  const PackageRecord folder = channel.record("a");
  const PackageRecord file = channel.record("b");
  for (const auto& records : {std::vector{folder, file}, std::vector{file, folder}}) {
    const auto both = make_environment(channel.store(), records);
    ASSERT_FALSE(both.ok());
    const Diagnostic& error = both.errors().front();
    EXPECT_EQ(error.code, "R2W0231");
    EXPECT_EQ(error.message, "`a-1.0-h_0` and `b-1.0-h_0` cannot be installed together");
    EXPECT_EQ(error.why.front(),
              "`lib/foo` is a folder in the first, but a file or a link in the second");
  }
}

TEST(PythonPackages, PathsInThePrefix) {
  EXPECT_EQ(path_in_prefix("site-packages/a/b.py", "lib/python3.13/site-packages"),
            "lib/python3.13/site-packages/a/b.py");
  EXPECT_EQ(path_in_prefix("python-scripts/tool", "x"), "bin/tool");
  for (const char* other : {"share/site-packages/a", "site-packages", "etc/a", "site-packages2/a"})
    EXPECT_EQ(path_in_prefix(other, "x"), other);
}

TEST(PythonPackages, WithoutAPythonThereIsNoPlaceForThem) {
  const PackageRecord generic = testing::made_record("a", "1.0");
  EXPECT_EQ(*site_packages_of({generic}, {"/none"}), "");
  PackageRecord module = testing::made_record("b", "1.0");
  module.noarch = NoarchKind::kPython;
  EXPECT_EQ(site_packages_of({generic, module}, {"/none", "/none"}).errors().front().code.text(),
            "R2W0242");
  const testing::TemporaryTree tree;
  tree.write("info/index.json", "{}");
  for (const auto& [version, place] :
       std::vector<std::pair<std::string, std::string>>{{"3.13.1", "lib/python3.13/site-packages"},
                                                        {"3.9", "lib/python3.9/site-packages"},
                                                        {"3", "R2W0242"},
                                                        {"3.x", "R2W0242"}}) {
    const auto found =
        site_packages_of({module, testing::made_record("python", version)}, {"/none", tree.root()});
    EXPECT_EQ(found.ok() ? *found : found.errors().front().code.text(), place) << version;
  }
}

TEST(PrefixText, BinaryKeepsItsLength) {
  using namespace std::string_literals;
  const std::string bytes = "\x7f/placeholder/lib:/placeholder/bin\0rest\0"s;
  const auto moved = with_prefix_in_binary(bytes, "/placeholder", "/p", "file");
  ASSERT_TRUE(moved.ok());
  EXPECT_EQ(*moved, "\x7f/p/lib:/p/bin"s + std::string(20, '\0') + "\0rest\0"s);
  EXPECT_EQ(moved->size(), bytes.size());
  EXPECT_EQ(with_prefix_in_binary(bytes, "/placeholder", "/a/longer/prefix", "file")
                .errors()
                .front()
                .code,
            "R2W0230");
}

}  // namespace
}  // namespace ros2wasm
