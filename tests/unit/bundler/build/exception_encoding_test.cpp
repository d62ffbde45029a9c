// The translation of exceptions when its tool is missing or fails; that it works is shown by pack's
// own tests.
#include "bundler/build/exception_encoding.hpp"

#include <gtest/gtest.h>

#include "tests/unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {
namespace fs = std::filesystem;
using testing::TemporaryTree;

TEST(ExceptionEncoding, WithoutTheToolNothingIsTranslated) {
  const TemporaryTree tree;
  const auto result =
      with_standard_exceptions("a program", tree / "bin/ros2wasm", tree / "cache", {});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.errors().front().code.text(), "R2W0509");
  EXPECT_EQ(result.errors().front().kind, FailureKind::kEnvironment);
}

TEST(ExceptionEncoding, WhatTheToolSaysIsShownAndNothingIsKept) {
  const TemporaryTree tree;
  tree.write("node_modules/.bin/wasm-opt", "not run: its interpreter is the script beside it");
  const auto node =
      tree.write("node_modules/.bin/node", "#!/bin/sh\necho 'Fatal: no module'\nexit 1\n");
  fs::permissions(node, fs::perms::owner_all);
  const auto result =
      with_standard_exceptions("not a program", tree / "bin/ros2wasm", tree / "cache", {});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.errors().front().code.text(), "R2W0509");
  EXPECT_EQ(result.errors().front().kind, FailureKind::kBug);
  EXPECT_NE(result.errors().front().detail.find("Fatal: no module"), std::string::npos);
  EXPECT_TRUE(fs::is_empty(tree / "cache/exnref"));
}

TEST(ExceptionEncoding, ATranslationIsTakenFromTheCache) {
  const TemporaryTree tree;
  // sha256 of the empty program
  tree.write("cache/exnref/e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855.wasm",
             "translated");
  const auto result = with_standard_exceptions("", tree / "bin/ros2wasm", tree / "cache", {});
  ASSERT_TRUE(result);
  EXPECT_EQ(*result, "translated");
}

}  // namespace
}  // namespace ros2wasm
