// What building says of the place it works in; builds themselves are shown by pack's own tests.
#include "bundler/build/build_workspace.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

TEST(LittleRoom, IsSaidOnlyWhenItCanBeTheReason) {
  EXPECT_FALSE(little_room("/cache", 64'000'000));
  const auto full = little_room("/cache", 4'200'000);
  ASSERT_TRUE(full);
  EXPECT_EQ(full->code, "R2W0640");
  EXPECT_EQ(full->kind, FailureKind::kEnvironment);
  EXPECT_EQ(full->message, "the disk has too little room to build: 4 MB are left");
  EXPECT_EQ(full->why.front(), "packages are built in /cache");
}

}  // namespace
}  // namespace ros2wasm
