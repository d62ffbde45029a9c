// Where the cache is, and when it is not used.
#include "bundler/store/cache_place.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include "unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

std::string cache_in(const testing::TemporaryTree& home, const std::string& xdg = {}) {
  const auto place = cache_directory({{"XDG_CACHE_HOME", xdg}, {"HOME", home.root().string()}});
  return place ? place->string()
               : place.errors().front().code.text() + ": " + place.errors().front().why.front();
}

TEST(CachePlace, FollowsXdgAndIsOfThisUserAlone) {
  const testing::TemporaryTree home;
  const testing::TemporaryTree other;
  EXPECT_EQ(cache_in(home), home / ".cache/ros2wasm");
  EXPECT_EQ(cache_in(home, "relative"), home / ".cache/ros2wasm");
  EXPECT_EQ(cache_in(home, other.root()), other / "ros2wasm");
  EXPECT_EQ(fs::status(other / "ros2wasm").permissions(), fs::perms::owner_all);
  // Without HOME it is where the system says that the user is at home, never below /tmp.
  const auto homeless = cache_directory({});
  EXPECT_TRUE(!homeless || !homeless->string().starts_with("/tmp")) << homeless->string();
}

// Guarantee, hostile input: a cache that belongs to another user, or that others can write to, is
// not used
TEST(CachePlace, IsRefusedWhereOthersCanWrite) {
  const testing::TemporaryTree home;
  ASSERT_EQ(cache_in(home), home / ".cache/ros2wasm");
  for (const fs::perms others : {fs::perms::group_write, fs::perms::others_write}) {
    fs::permissions(home / ".cache/ros2wasm", fs::perms::owner_all | others);
    EXPECT_EQ(cache_in(home), "R2W0244: other users can write to it");
  }
  fs::permissions(home / ".cache/ros2wasm", fs::perms::owner_all | fs::perms::group_read);
  EXPECT_EQ(cache_in(home), home / ".cache/ros2wasm");
  // A folder of another user: root makes one; others have the system's.
  if (::geteuid() == 0) {
    ASSERT_EQ(::chown((home / ".cache/ros2wasm").c_str(), 12345, 12345), 0);
  } else {
    fs::remove(home / ".cache/ros2wasm");
    fs::create_directory_symlink("/usr", home / ".cache/ros2wasm");
  }
  EXPECT_EQ(cache_in(home).substr(0, 41), "R2W0244: it belongs to another user (numb");
}

}  // namespace
}  // namespace ros2wasm
