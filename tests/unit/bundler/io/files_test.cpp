// Reading, writing and hashing files.
#include "bundler/io/files.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "bundler/io/sha256.hpp"
#include "unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

TEST(Files, AreReadWhole) {
  const testing::TemporaryTree tree;
  const std::string bytes("a\0b\nc", 5);
  EXPECT_EQ(*read_file(tree.write("x", bytes)), bytes);
  EXPECT_EQ(*read_file(tree.write("empty", "")), "");
  EXPECT_EQ(read_file(tree / "absent").errors().front().code, "R2W0210");
  EXPECT_EQ(read_file(tree.root()).errors().front().code, "R2W0210");
}

TEST(Files, AreReplacedWholeOrNotAtAll) {
  const testing::TemporaryTree tree;
  ASSERT_TRUE(write_file(tree / "deep/down/x", "one").ok());
  ASSERT_TRUE(write_file(tree / "deep/down/x", "two").ok());
  EXPECT_EQ(tree.read("deep/down/x"), "two");
  EXPECT_EQ(std::distance(fs::directory_iterator(tree / "deep/down"), {}), 1);
  tree.write("file", "");
  EXPECT_EQ(write_file(tree / "file/below", "x").errors().front().code, "R2W0211");
}

TEST(Files, APathWithinARootMayGoByLinksThatStayThere) {
  const testing::TemporaryTree tree;
  tree.write("root/deep/x", "");
  tree.write("root_too/x", "");
  fs::create_directory_symlink("deep", tree / "root/same");
  fs::create_directory_symlink(tree / "root_too", tree / "root/out");
  fs::create_directory_symlink("root", tree / "door");
  const fs::path real = fs::canonical(tree / "root/deep/x");
  EXPECT_EQ(path_within(tree / "root", tree / "root/same/x"), real);
  EXPECT_EQ(path_within(tree / "door", tree / "door/deep/../deep/x"), real);
  EXPECT_EQ(path_within(tree / "root", tree / "root"), fs::canonical(tree / "root"));
  for (const char* path : {"root/out/x", "root/out", "root/../root_too/x", "root/absent", ""})
    EXPECT_EQ(path_within(tree / "root", tree / path), std::nullopt) << path;
  EXPECT_EQ(path_within(tree / "absent", tree / "absent"), std::nullopt);
}

TEST(Files, SameBytesAreNotWrittenAgain) {
  const testing::TemporaryTree tree;
  ASSERT_TRUE(write_file(tree / "x", "one").ok());
  struct stat before {};
  ASSERT_EQ(::stat((tree / "x").c_str(), &before), 0);
  ASSERT_TRUE(write_file(tree / "x", "one").ok());
  struct stat after {};
  ASSERT_EQ(::stat((tree / "x").c_str(), &after), 0);
  EXPECT_EQ(before.st_ino, after.st_ino);
}

TEST(Files, TreesAreListedInOrder) {
  const testing::TemporaryTree tree;
  tree.write("b/x", "1");
  tree.write("a", "22");
  fs::create_directories(tree / "empty/inside");
  fs::create_symlink("../a", tree / "b/link");
  const auto entries = list_tree(tree.root());
  ASSERT_TRUE(entries.ok());
  std::string text;
  for (const TreeEntry& entry : *entries)
    text += entry.path + " " + std::to_string(entry.size) + entry.link_target + "\n";
  EXPECT_EQ(text, "a 2\nb/link 0../a\nb/x 1\nempty/inside 0\n");
}

TEST(Files, TemporaryDirectoriesRemoveThemselves) {
  const testing::TemporaryTree tree;
  fs::path path;
  {
    auto temporary = TemporaryDirectory::make(tree / "tmp", "x.");
    ASSERT_TRUE(temporary.ok());
    path = temporary->path();
    fs::create_directories(path / "locked");
    fs::permissions(path / "locked", fs::perms::none);
    EXPECT_TRUE(fs::is_directory(path));
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST(Sha256, KnownDigests) {
  EXPECT_EQ(sha256_hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  const testing::TemporaryTree tree;
  const auto hashes = hash_file(tree.write("x", "abc"), true);
  ASSERT_TRUE(hashes.ok());
  EXPECT_EQ(hashes->md5, "900150983cd24fb0d6963f7d28e17f72");
  EXPECT_EQ(hashes->size, 3U);
}

}  // namespace
}  // namespace ros2wasm
