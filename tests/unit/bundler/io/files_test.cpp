// Reading, writing and hashing files.
#include "bundler/io/files.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "bundler/io/mapped_file.hpp"
#include "bundler/io/sha256.hpp"
#include "unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

TEST(Files, AreReadWhole) {
  const testing::TemporaryTree tree;
  const std::string bytes("a\0b\nc", 5);
  EXPECT_EQ(*read_file(tree.write("x", bytes), kMostOfData), bytes);
  EXPECT_EQ(*read_file(tree.write("empty", ""), kMostOfData), "");
  EXPECT_EQ(read_file(tree / "absent", kMostOfData).errors().front().code.text(), "R2W0210");
  EXPECT_EQ(read_file(tree.root(), kMostOfData).errors().front().code.text(), "R2W0210");
}

// Guarantee, hostile input: a manifest, a lock or a course that is there and cannot be read is
// never taken as absent
TEST(Files, OnlyWhatHasNoNameIsAbsent) {
  const testing::TemporaryTree tree;
  EXPECT_TRUE(is_absent(tree / "x"));
  EXPECT_TRUE(is_absent(tree / "no/folder/x"));
  EXPECT_TRUE(is_absent(tree.write("file", "") / "x"));
  EXPECT_FALSE(is_absent(tree / "file"));
  EXPECT_FALSE(is_absent(tree.root()));
  fs::create_symlink("loop", tree / "loop");
  fs::create_symlink("nowhere", tree / "dangling");
  EXPECT_EQ(::mkfifo((tree / "pipe").c_str(), 0600), 0);
  for (const char* name : {"loop", "dangling", "pipe", "loop/x"})
    EXPECT_FALSE(is_absent(tree / name)) << name;
}

std::string why_not_read(const fs::path& path, std::uint64_t at_most = kMostOfText) {
  const auto text = read_file(path, at_most);
  return text ? "it was read"
              : text.errors().front().code.text() + ": " + text.errors().front().why.front();
}

// Guarantee, hostile input: a pipe, socket or device in the place of a file is neither waited for
// nor read without end, and a file that is larger than one of its kind can be is not read
TEST(Files, OnlyRegularFilesAreRead) {
  const testing::TemporaryTree tree;
  ASSERT_EQ(::mkfifo((tree / "pipe").c_str(), 0600), 0);
  fs::create_symlink("/dev/zero", tree / "zero");
  fs::create_symlink("loop", tree / "loop");
  const int listening = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{.sun_family = AF_UNIX, .sun_path = {}};
  const std::string place = (tree / "socket").string();
  ASSERT_LT(place.size(), sizeof address.sun_path);
  place.copy(address.sun_path, place.size());
  ASSERT_EQ(::bind(listening, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  EXPECT_EQ(why_not_read(tree / "pipe"), "R2W0210: it is a pipe, not a file");
  EXPECT_EQ(why_not_read(tree / "socket"), "R2W0210: it is a socket, not a file");
  EXPECT_EQ(why_not_read(tree / "zero"), "R2W0210: it is a device, not a file");
  EXPECT_EQ(why_not_read(tree.root()), "R2W0210: Is a directory");
  EXPECT_EQ(why_not_read(tree / "loop"), "R2W0210: Too many levels of symbolic links");
  ::close(listening);
  for (const char* name : {"pipe", "zero", "socket"}) {
    EXPECT_FALSE(hash_file(tree / name)) << name;
    EXPECT_FALSE(MappedFile::open(tree / name)) << name;
  }
}

TEST(Files, AreReadUpToALimit) {
  const testing::TemporaryTree tree;
  EXPECT_EQ(why_not_read(tree.write("x", "12345"), 5), "it was read");
  EXPECT_EQ(why_not_read(tree / "x", 4),
            "R2W0210: it has 5 bytes or more; of such a file at most 4 are read");
  fs::resize_file(tree / "x", std::uintmax_t{1} << 40U);  // takes no place on the disk
  EXPECT_EQ(why_not_read(tree / "x").substr(0, 35), "R2W0210: it has 1099511627776 bytes");
  const auto hashes = hash_file(tree / "x");
  ASSERT_FALSE(hashes);
  EXPECT_EQ(hashes.errors().front().why.front().substr(0, 26), "it has 1099511627776 bytes");
  // Files of the kernel do not say how long they are.
  EXPECT_EQ(why_not_read("/proc/self/status"), "it was read");
  EXPECT_EQ(why_not_read("/proc/self/status", 10).substr(0, 19), "R2W0210: it has 11 ");
}

TEST(Files, NamesMayBeAsLongAsAFileSystemAllows) {
  const testing::TemporaryTree tree;
  const std::string longest(kLongestName, 'n');
  ASSERT_TRUE(write_file(tree / longest, "x").ok());
  EXPECT_EQ(tree.read(longest), "x");
  EXPECT_EQ(write_file(tree / (longest + "n"), "x").errors().front().why.front(),
            "File name too long");
  EXPECT_TRUE(TemporaryDirectory::make(tree.root(), longest).ok());
}

TEST(Files, APathIsMadeWholeOnlyWhereThereIsACurrentFolder) {
  const testing::TemporaryTree tree;
  EXPECT_EQ(*absolute_path("/a/../b"), "/a/../b");
  EXPECT_FALSE(absolute_path(""));
  fs::create_directory_symlink("/usr", tree / "link");
  EXPECT_EQ(*real_path(tree / "link/absent"), "/usr/absent");
  EXPECT_DEATH_IF_SUPPORTED(
      {
        fs::create_directory(tree / "gone");
        fs::current_path(tree / "gone");
        fs::remove(tree / "gone");
        const auto path = absolute_path("x");
        std::fputs(path ? "a path" : path.errors().front().why.front().c_str(), stderr);
        std::abort();
      },
      "it is relative, and the current folder has been removed");
}

TEST(Files, AreReplacedWholeOrNotAtAll) {
  const testing::TemporaryTree tree;
  ASSERT_TRUE(write_file(tree / "deep/down/x", "one").ok());
  ASSERT_TRUE(write_file(tree / "deep/down/x", "two").ok());
  EXPECT_EQ(tree.read("deep/down/x"), "two");
  EXPECT_EQ(std::distance(fs::directory_iterator(tree / "deep/down"), {}), 1);
  tree.write("file", "");
  EXPECT_EQ(write_file(tree / "file/below", "x").errors().front().code.text(), "R2W0211");
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

TEST(Files, AFolderThatCannotBeReadIsNamed) {
  if (::geteuid() == 0) {
    // Nothing is closed to root but what is gone: a folder of the kernel whose entries cannot be
    // read.
    EXPECT_EQ(list_tree("/proc/self/absent").errors().front().message,
              "cannot read `/proc/self/absent`");
    return;
  }
  const testing::TemporaryTree tree;
  tree.write("closed/x", "1");
  fs::permissions(tree / "closed", fs::perms::none);
  EXPECT_EQ(list_tree(tree.root()).errors().front().message,
            "cannot read `" + (tree / "closed").string() + "`");
  fs::permissions(tree / "closed", fs::perms::owner_all);
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
