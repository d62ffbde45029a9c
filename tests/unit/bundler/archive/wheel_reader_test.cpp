// Wheels: what is read of a good one, and how each bad one is refused.
#include "bundler/archive/wheel_reader.hpp"

#include <gtest/gtest.h>

#include "bundler/archive/zip_writer.hpp"
#include "unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

constexpr const char* kModule = "x = 1\n";
constexpr const char* kWheel = "Wheel-Version: 1.0\n";
constexpr const char* kMetadata =
    "Name: Parts\nVersion: 1.2\nRequires-Dist: numpy (>=1.20)\nRequires-Python: >=3.8\n\n"
    "Name: other\n";

struct Member {
  std::string path;
  std::string body;
};

/// As Python's hashlib and base64 say, so that our own digits are not their own judge.
std::string hash_of(const std::string& body) {
  static const std::map<std::string, std::string> kHashes{
      {"", "47DEQpj8HBSa-_TImW-5JCeuQeRkm5NMpJWZG3hSuFU"},
      {kModule, "nia_NpkRxFwkPGhBR7I_yeHc_PJX0pmhxjIBam_NM_Q"},
      {kWheel, "hPnzolO11CFKQQfo-cfRSowPfsQIecdrr39HeOvVHcE"},
      {"Wheel-Version: 2.0\n", "RbQk38F6iwz_jXXdhsJCbT_uGimgNlxw82YNdhgI4gE"},
      {kMetadata, "_eMcALScdJkUgISXYjs0D1YV_CwAmkTzwm1nKsW-rs4"},
      {"Name: other\nVersion: 1.2\n", "PmwS_KaXAfdPbkM7GFz7gl8X4F9zJ6vt1IxI3cBIQ-M"},
      {"Name: parts\nVersion: 1.3\n", "9y1E-q6zjltBy2yUaTtXZ1y-m7CpPMOrfM1faXP_fKM"}};
  return kHashes.at(body);
}

class WheelReader : public ::testing::Test {
 protected:
  static std::vector<Member> good(const std::string& metadata = kMetadata,
                                  const std::string& wheel = kWheel) {
    return {{"parts/__init__.py", ""},
            {"parts/arm.py", kModule},
            {"parts-1.2.dist-info/METADATA", metadata},
            {"parts-1.2.dist-info/WHEEL", wheel}};
  }

  static std::string row(const Member& member) {
    return "\"" + member.path + "\",sha256=" + hash_of(member.body) + "," +
           std::to_string(member.body.size()) + "\r\n";
  }

  static std::string record_of(const std::vector<Member>& members) {
    std::string record = "parts-1.2.dist-info/RECORD,,\r\n";
    for (const Member& one : members) record += row(one);
    return record;
  }

  Outcome<Wheel> read(const std::vector<Member>& members, const std::string& record,
                      const ExtractLimits& limits = {}) {
    ZipWriter zip;
    for (const Member& one : members) zip.member(one.path, one.body);
    if (!record.empty()) zip.member("parts-1.2.dist-info/RECORD", record);
    return read_bytes(zip.finish(), limits);
  }

  Outcome<Wheel> read_bytes(const std::string& bytes, const ExtractLimits& limits = {}) {
    const auto file = tree_.write("parts-1.2-py3-none-any.whl", bytes);
    return read_wheel(file, *wheel_name("parts-1.2-py3-none-any.whl"), limits);
  }

  /// The code with which it is refused, or "read".
  std::string code(const std::vector<Member>& members, const ExtractLimits& limits = {}) {
    const auto wheel = read(members, record_of(members), limits);
    return wheel ? "read" : wheel.errors().front().code.text();
  }

  std::string code_with(const Member& more) {
    std::vector<Member> members = good();
    members.push_back(more);
    return code(members);
  }

  testing::TemporaryTree tree_;
};

TEST_F(WheelReader, ModulesWithTheirMetadata) {
  auto members = good();
  members.push_back({"parts-1.2.data/purelib/more.py", kModule});
  members.push_back({"parts-1.2.data/scripts/run", kModule});
  members.push_back({"parts-1.2.data/data/etc/parts", kModule});
  members.push_back({"parts/__pycache__/arm.pyc", ""});
  const auto wheel = read(members, record_of(members));
  ASSERT_TRUE(wheel.ok());
  EXPECT_EQ(wheel->project, "Parts");
  EXPECT_EQ(wheel->version, "1.2");
  EXPECT_EQ(wheel->python, ">=3.8");
  EXPECT_EQ(wheel->requirements, std::vector<std::string>{"numpy (>=1.20)"});
  std::vector<std::string> paths;
  for (const auto& [path, bytes] : wheel->files) paths.push_back(path);
  EXPECT_EQ(paths, (std::vector<std::string>{
                       "more.py", "parts-1.2.dist-info/METADATA", "parts-1.2.dist-info/RECORD",
                       "parts-1.2.dist-info/WHEEL", "parts/__init__.py", "parts/arm.py"}));
  EXPECT_EQ(wheel->files.at("parts/arm.py"), kModule);
}

// Guarantee, hostile input: wheels: names that lead outside, names twice, too many bytes or members
TEST_F(WheelReader, NothingOfAHostileOneIsTaken) {
  for (const char* name : {"../up.py", "/etc/x.py", "a/../../x.py", "x\ny.py"})
    EXPECT_EQ(code_with({name, kModule}), "R2W0222") << name;
  EXPECT_EQ(code_with({"parts/arm.py", kModule}), "R2W0224");
  EXPECT_EQ(code_with({"parts/ARM.py", kModule}), "R2W0224");
  EXPECT_EQ(code(good(), {.members = 3}), "R2W0225");
  EXPECT_EQ(code(good(), {.total_bytes = 20}), "R2W0225");
  EXPECT_EQ(read_bytes("no zip").errors().front().code.text(), "R2W0221");
  EXPECT_EQ(read_bytes("").errors().front().code.text(), "R2W0221");
}

// Guarantee, hostile input: Python libraries that unpack to more than 256 MiB
TEST_F(WheelReader, IsNoLargerThanAPageCanHold) {
  ZipWriter zip;
  const std::string block(std::size_t{30} << 20U, 'x');
  for (int i = 0; i < 10; ++i) zip.member("parts/" + std::to_string(i) + ".bin", block);
  const auto file = tree_.write("large.whl", zip.finish());
  const WheelName name = *wheel_name("parts-1.2-py3-none-any.whl");
  EXPECT_EQ(read_wheel(file, name, {}).errors().front().code.text(), "R2W0225");
  EXPECT_EQ(read_shared_libraries(file, "large.zip", {}).errors().front().code.text(), "R2W0225");
}

TEST_F(WheelReader, CompiledModulesAreThoseOfSideModules) {
  const std::string module("\0asm\1\0\0\0", 8);
  const auto file = tree_.write("teeth.zip", [&] {
    ZipWriter zip;
    zip.member("libteeth.so", module);
    return zip.finish();
  }());
  const auto refused = read_shared_libraries(file, "teeth.zip", {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.errors().front().code.text(), "R2W0245");
  EXPECT_EQ(refused.errors().front().message,
            "the compiled module `libteeth.so` of `teeth.zip` is not one that a site may load");
  ZipWriter empty;
  empty.member("README", "nothing");
  const auto other = tree_.write("empty.zip", empty.finish());
  EXPECT_EQ(read_shared_libraries(other, "empty.zip", {}).errors().front().code.text(), "R2W0221");
}

TEST_F(WheelReader, RecordHasEveryFileWithItsHash) {
  const auto refused = [&](const std::string& record) {
    const auto wheel = read(good(), record);
    return !wheel && wheel.errors().front().code.text() == "R2W0226";
  };
  const std::string record = record_of(good());
  EXPECT_FALSE(refused(record));
  const std::string arm = row(good()[1]);
  const auto with_arm = [&](const std::string& line) {
    std::string text = record;
    return text.replace(text.find(arm), arm.size(), line);
  };
  EXPECT_TRUE(refused(with_arm("")));
  EXPECT_TRUE(refused(with_arm("parts/arm.py,,\n")));
  EXPECT_TRUE(refused(with_arm("parts/arm.py,md5=x,6\n")));
  EXPECT_TRUE(refused(with_arm("parts/arm.py,sha256=" + hash_of("") + ",6\n")));
  EXPECT_TRUE(refused(with_arm("parts/arm.py,sha256=" + hash_of(kModule) + ",7\n")));
  EXPECT_TRUE(refused(record + "parts/gone.py,sha256=" + hash_of("") + ",0\n"));
  EXPECT_TRUE(refused(record + "\"parts\n"));
}

TEST_F(WheelReader, WhatIsNoWheelForASite) {
  EXPECT_EQ(code(good("Name: other\nVersion: 1.2\n")), "R2W0243");
  EXPECT_EQ(code(good("Name: parts\nVersion: 1.3\n")), "R2W0243");
  EXPECT_EQ(code(good(kMetadata, "Wheel-Version: 2.0\n")), "R2W0243");
  EXPECT_EQ(code_with({"parts/fast.cpython-312-x86_64-linux-gnu.so", ""}), "R2W0243");
  auto members = good();
  members.erase(members.begin() + 2);
  EXPECT_EQ(code(members), "R2W0221");
  EXPECT_EQ(read(good(), "").errors().front().code.text(), "R2W0221");
  members = good();
  members.push_back({"other-1.dist-info/METADATA", ""});
  EXPECT_EQ(code(members), "R2W0221");
}

}  // namespace
}  // namespace ros2wasm
