// Where two files of a site differ, in the words of their format.
#include "bundler/verify/site_diff.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace ros2wasm {
namespace {

std::string module_of(const std::string& sections) {
  return std::string("\0asm\1\0\0\0", 8) + sections;
}

// Guarantee, same bytes: where two sites differ, `diff` names of each file the first section, key,
// line or byte
TEST(FirstDifference, NamesTheSectionOfAModuleAndTheByteInIt) {
  const std::string type("\1\1\0", 3);
  const std::string code_a("\12\3\1\1a", 5);
  const std::string code_b("\12\3\1\1b", 5);
  const std::string note("\0\5\4note", 7);
  EXPECT_EQ(first_difference("a.wasm", module_of(type + code_a), module_of(type + code_b)),
            "section `code`, byte 4 of it");
  EXPECT_EQ(first_difference("a.wasm", module_of(type), module_of(type + note)),
            "custom section `note`, which only the second has");
  EXPECT_EQ(first_difference("a.wasm", module_of(type + note), module_of(code_a + note)),
            "section `type`, where the second has section `code`");
}

TEST(FirstDifference, NamesTheKeyOfAnObject) {
  EXPECT_EQ(first_difference("a.json", R"({"a":{"b":[1,2]}})", R"({"a":{"b":[1,3]}})"),
            "`a.b[1]`: `2`, the second has `3`");
  EXPECT_EQ(first_difference("a.json", R"({"a":1,"c":true})", R"({"a":1})"),
            "`c`, which only the first has");
  EXPECT_EQ(first_difference("a.json", R"({"a":1.5})", R"({"a":[]})"),
            "`a`: another value, the second has 0 items");
}

// Guarantee, hostile input: `diff` of lists with objects of a hundred thousand members ends in
// seconds
TEST(FirstDifference, ObjectsOfManyMembers) {
  std::string members;
  for (int i = 0; i < 100'000; ++i) members += "\"k" + std::to_string(i) + "\":" + "0,";
  const auto text = [&](const char* last) {
    return R"({"a":{"b":{)" + members + "\"end\":" + last + "}}}";
  };
  const auto begun = std::chrono::steady_clock::now();
  EXPECT_EQ(first_difference("a.json", text("1"), text("2")), "`a.b.end`: `1`, the second has `2`");
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(20));
}

TEST(FirstDifference, NamesTheLineOfATextAndTheByteOfAnythingElse) {
  EXPECT_EQ(first_difference("a.txt", "one\ntwo\n", "one\nto\n"), "line 2");
  EXPECT_EQ(first_difference("a.zip", std::string("a\0b", 3), std::string("a\0cd", 4)),
            "byte 2 (3 and 4 bytes)");
}

}  // namespace
}  // namespace ros2wasm
