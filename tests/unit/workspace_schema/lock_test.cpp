// The lock: one form for one content, and what is refused.
#include "workspace_schema/schema/lock.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace ros2wasm {
namespace {

PackageRecord record(const std::string& name) {
  return PackageRecord{.name = name,
                       .version = "1.0",
                       .build = "h0_0",
                       .build_number = 3,
                       .subdir = "noarch",
                       .channel = "embedded",
                       .file_name = name + "-1.0-h0_0.conda",
                       .url = "embedded:/noarch/" + name + "-1.0-h0_0.conda",
                       .sha256 = std::string(64, 'a'),
                       .md5 = std::string(32, 'b'),
                       .size = 1234,
                       .depends = {"other >=1,<2", "__unix", "x[version='>=1']"},
                       .constrains = {"third 1.*"},
                       .license = "Apache-2.0 AND MIT",
                       .timestamp_ms = 1'700'000'000'000,
                       .noarch = NoarchKind::kGeneric};
}

Lock lock() {
  return Lock{.channels = {"embedded", "./own: channel"},
              .specs = {"b >=1", "a"},
              .absent = {"ros-jazzy-gazebo-ros"},
              .packages = {record("b"), record("a"), record("yes"), record("1e3")}};
}

constexpr const char* kText =
    R"(# Which packages this workspace uses, exactly. Written by ros2wasm; keep it under version control.
schema: 1
platform: emscripten-wasm32
channels:
  - embedded
specs:
  - a
packages:
  - name: a
    version: "1.0"
    build: h0_0
    build_number: 3
    subdir: noarch
    channel: embedded
    file: a-1.0-h0_0.conda
    url: "embedded:/noarch/a-1.0-h0_0.conda"
    sha256: aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa
    md5: bbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbb
    size: 1234
    depends:
      - "other >=1,<2"
      - __unix
      - "x[version='>=1']"
    constrains:
      - third 1.*
    license: Apache-2.0 AND MIT
    timestamp_ms: 1700000000000
    noarch: generic
)";

TEST(Lock, KeepsWheels) {
  const LockedWheel beside{.project = "parts",
                           .version = "1.0",
                           .file = "wheels/parts-1.0-py3-none-any.whl",
                           .url = "",
                           .sha256 = std::string(64, 'a'),
                           .size = 12};
  LockedWheel far = beside;
  far.file.clear();
  far.url = "https://example.org/parts-1.0-py3-none-any.whl";
  Lock with = lock();
  with.wheels = {beside, far};
  const std::string text = write_lock(with);
  const auto read = read_lock(text, "ros2wasm.lock");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->wheels, with.wheels);
  EXPECT_EQ(write_lock(*read), text);
  with.wheels.front().url = far.url;  // only one of both is written
  EXPECT_TRUE(read_lock(write_lock(with), "ros2wasm.lock").ok());
  EXPECT_FALSE(read_lock(text + "  - name: a\n", "ros2wasm.lock").ok());
  EXPECT_FALSE(read_lock(text + "    file: both\n", "ros2wasm.lock").ok());
}

TEST(Lock, HasOneForm) {
  EXPECT_EQ(write_lock({.channels = {"embedded"}, .specs = {"a"}, .packages = {record("a")}}),
            kText);
}

TEST(Lock, OrderOfPackagesAndSpecsDoesNotMatter) {
  Lock other = lock();
  std::reverse(other.packages.begin(), other.packages.end());
  std::reverse(other.specs.begin(), other.specs.end());
  EXPECT_EQ(write_lock(lock()), write_lock(other));
}

TEST(Lock, IsReadAsItWasWritten) {
  const std::string text = write_lock(lock());
  const auto read = read_lock(text, "ros2wasm.lock");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->channels, lock().channels);
  EXPECT_EQ(read->absent, lock().absent);
  EXPECT_EQ(read->packages.size(), 4U);
  for (const PackageRecord& one : lock().packages) {
    EXPECT_NE(std::find(read->packages.begin(), read->packages.end(), one), read->packages.end())
        << one.name;
  }
  EXPECT_EQ(write_lock(*read), text);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

/// A lock whose package, with its file and its url, has another name.
std::string renamed(const std::string& name) {
  std::string text = replaced(kText, "- name: a", "- name: " + name);
  text = replaced(text, "file: a-", "file: " + name + "-");
  return replaced(text, "noarch/a-", "noarch/" + name + "-");
}

TEST(Lock, RefusesWhatIsNone) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "not a map"},
      {"[1", "R2W0310"},
      {"schema: 2\nplatform: x\npackages: []\n", "schema 2"},
      {"schema: 1\nplatform: x\n", "`packages` is missing"},
      {replaced(kText, "size: 1234", "size: -1"), "a number that is not negative"},
      {replaced(kText, "size: 1234", "size: many"), "a number that is not negative"},
      {replaced(kText, "md5: bbb", "md5: bxb"), "a hash of 32"},
      {replaced(kText, "noarch: generic", "noarch: true"), "`noarch` is"},
      {replaced(kText, "version: \"1.0\"", "version: \"1.1\""), "is not that of `a-1.1-h0_0`"},
      {replaced(kText, "noarch/a-1.0", "noarch/b-1.0"), "does not end with its file"},
      {replaced(kText, "subdir: noarch", "subdir: ../.."), "the subdirectory `../..`"},
      {renamed("../a"), "the name `../a`"},
      {renamed("a/../../b"), "the name `a/../../b`"},
      {renamed("/a"), "the name `/a`"},
      {replaced(kText, "license:", "licence:"), "unknown key `licence`"},
      {replaced(kText, "    url: \"embedded:/noarch/a-1.0-h0_0.conda\"\n", ""), "`url` is missing"},
      {replaced(kText, "channels:\n  - embedded", "channels: embedded"), "a list is expected"}};
  for (const auto& [text, expected] : cases) {
    const auto read = read_lock(text, "ros2wasm.lock");
    ASSERT_FALSE(read.ok()) << text;
    const Diagnostic& error = read.errors().front();
    EXPECT_EQ(error.code, "R2W0310");
    EXPECT_NE((error.code + error.message).find(expected), std::string::npos) << error.message;
  }
}

TEST(Lock, SaysAllFaultsWithTheirPlaces) {
  const auto read = read_lock(
      replaced(replaced(kText, "size: 1234", "size: x"), "md5: bbb", "md5: bxb"), "ros2wasm.lock");
  ASSERT_FALSE(read.ok());
  ASSERT_EQ(read.errors().size(), 2U);
  EXPECT_EQ(read.errors()[0].span->line, 18U);
  EXPECT_EQ(read.errors()[1].span->line, 19U);
}

TEST(Lock, RefusesAPackageTwice) {
  Lock twice{.packages = {record("a"), record("a")}};
  EXPECT_FALSE(read_lock(write_lock(twice), "ros2wasm.lock").ok());
}

}  // namespace
}  // namespace ros2wasm
