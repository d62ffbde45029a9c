// Archives that no honest tool makes: each is refused with its code, and nothing is written
// outside.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <numeric>

#include "bundler/archive/link_rules.hpp"
#include "bundler/archive/package_listing.hpp"
#include "bundler/archive/package_reader.hpp"
#include "bundler/archive/zip_writer.hpp"
#include "bundler/archive/zstd.hpp"
#include "bundler/io/sha256.hpp"
#include "unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

/// Members exactly as given, whatever they are.
class RawTar {
 public:
  RawTar& add(const std::string& name, char type, const std::string& body = {},
              const std::string& target = {}) {
    std::array<char, 512> head{};
    std::memcpy(head.data(), name.data(), std::min<std::size_t>(name.size(), 100));
    std::memcpy(head.data() + 100, "0000644", 7);
    std::memcpy(head.data() + 108, "0000000", 7);
    std::memcpy(head.data() + 116, "0000000", 7);
    std::snprintf(head.data() + 124, 12, "%011zo", body.size());
    std::memcpy(head.data() + 136, "00000000000", 11);
    std::memset(head.data() + 148, ' ', 8);
    head[156] = type;
    std::memcpy(head.data() + 157, target.data(), std::min<std::size_t>(target.size(), 100));
    std::memcpy(head.data() + 257, "ustar\00000", 8);
    const unsigned sum = std::accumulate(head.begin(), head.end(), 0U, [](unsigned total, char c) {
      return total + static_cast<unsigned char>(c);
    });
    std::snprintf(head.data() + 148, 8, "%06o", sum);
    bytes_.append(head.data(), head.size()).append(body);
    bytes_.append((512 - bytes_.size() % 512) % 512, '\0');
    return *this;
  }
  RawTar& file(const std::string& name, const std::string& body) { return add(name, '0', body); }
  [[nodiscard]] std::string bytes() const { return bytes_ + std::string(1024, '\0'); }

 private:
  std::string bytes_;
};

std::string paths_json(const std::vector<std::pair<std::string, std::string>>& files) {
  std::string text;
  for (const auto& [path, body] : files) {
    text += (text.empty() ? "" : ",") + std::string("{\"_path\":\"") + path +
            "\",\"path_type\":\"hardlink\",\"sha256\":\"" + sha256_hex(body) +
            "\",\"size_in_bytes\":" + std::to_string(body.size()) + "}";
  }
  return "{\"paths\":[" + text + "],\"paths_version\":1}";
}

std::string conda(const RawTar& files, const RawTar& info) {
  ZipWriter zip;
  zip.member("info-x-1-0.tar.zst", zstd_compressed(info.bytes(), 3));  // any order is fine
  zip.member("pkg-x-1-0.tar.zst", zstd_compressed(files.bytes(), 3));
  return zip.finish();
}

RawTar good_info() {
  return RawTar()
      .file("info/index.json", "{}")
      .file("info/paths.json", paths_json({{"a", "body"}}));
}

class HostileArchive : public ::testing::Test {
 protected:
  /// The code with which the archive is refused, or "unpacked".
  std::string code(const std::string& bytes, const ExtractLimits& limits = {},
                   const std::string& name = "x-1-0.conda") {
    const fs::path archive = tree_.write(name, bytes);
    fs::remove_all(tree_ / "deep");
    fs::create_directories(tree_ / "deep/down/out");
    const auto unpacked = unpack_package(archive, tree_ / "deep/down/out", "x", limits);
    // Nothing but `out` may be there.
    EXPECT_EQ(std::distance(fs::directory_iterator(tree_ / "deep"), {}), 1);
    EXPECT_EQ(std::distance(fs::directory_iterator(tree_ / "deep/down"), {}), 1);
    EXPECT_FALSE(fs::exists("/ros2wasm-escaped"));
    why_ = unpacked.ok() ? std::vector<std::string>() : unpacked.errors().front().why;
    return unpacked.ok() ? "unpacked" : unpacked.errors().front().code.text();
  }
  std::string code(const RawTar& files) { return code(conda(files, good_info())); }

  testing::TemporaryTree tree_;
  std::vector<std::string> why_;
};

TEST_F(HostileArchive, AGoodOneIsUnpacked) {
  EXPECT_EQ(code(RawTar().file("a", "body")), "unpacked");
}

// Guarantee, hostile input: archives: names that are absolute or lead outside
TEST_F(HostileArchive, NamesThatLeadOutside) {
  for (const char* name : {"../a", "b/../../a", "/ros2wasm-escaped", "..", "a/..", "x\ny"}) {
    EXPECT_EQ(code(RawTar().file("a", "body").file(name, "evil")), "R2W0222") << name;
  }
}

TEST_F(HostileArchive, DevicesAndPipes) {
  for (const char type : {'3', '4', '6'})
    EXPECT_EQ(code(RawTar().file("a", "body").add("d", type)), "R2W0222") << type;
}

// Guarantee, hostile input: archives: links that lead outside, and files written through links
TEST_F(HostileArchive, LinksThatLeadOutside) {
  for (const char* target : {"/etc/passwd", "../../x", "..", "b/../../../x", "b/.."}) {
    EXPECT_EQ(code(RawTar().file("a", "body").add("l", '2', {}, target)), "R2W0223") << target;
  }
  EXPECT_EQ(code(RawTar().file("a", "body").add("h", '1', {}, "/etc/passwd")), "R2W0223");
  EXPECT_EQ(code(RawTar().file("a", "body").add("h", '1', {}, "../../up")), "R2W0223");
  EXPECT_EQ(code(RawTar().file("a", "body").add("h", '1', {}, "not-there")), "R2W0223");
}

// Guarantee, hostile input: archives: links that each stay inside and lead outside together
TEST_F(HostileArchive, ChainsOfLinksThatLeadOutside) {
  EXPECT_EQ(code(RawTar()
                     .file("a/b/c/d", "body")
                     .add("a/b/c/s", '2', {}, "../..")
                     .add("t", '2', {}, "a/b/c/s/../../x")),
            "R2W0223");
}

TEST_F(HostileArchive, LinksWithoutATargetAreRestoredByTheirHash) {
  const auto info = [](const std::string& linked) {
    return RawTar().file("info/paths.json", paths_json({{"a", "body"}, {"l", linked}}));
  };
  const RawTar files = RawTar().file("a", "body").add("l", '2');
  EXPECT_EQ(code(conda(files, info("body"))), "unpacked");
  EXPECT_EQ(std::filesystem::file_size(tree_ / "deep/down/out/l"), 4U);
  EXPECT_EQ(code(conda(files, info("other"))), "R2W0226");
}

TEST_F(HostileArchive, NothingIsWrittenThroughALink) {
  EXPECT_EQ(code(RawTar().file("a", "body").add("d", '2', {}, "e").file("d/x", "evil")), "R2W0224");
  EXPECT_EQ(code(RawTar().file("a", "body").add("d", '2', {}, "e").add("d/l", '2', {}, "f")),
            "R2W0224");
}

// Guarantee, hostile input: archives: two members with one name, also by case
TEST_F(HostileArchive, TwoMembersWithOneName) {
  EXPECT_EQ(code(RawTar().file("a", "body").file("a", "body")), "R2W0224");
  EXPECT_EQ(code(RawTar().file("a", "body").file("./a", "body")), "R2W0224");
  EXPECT_EQ(code(RawTar().file("a", "body").file("A", "body")), "R2W0224");
  EXPECT_EQ(code(RawTar().file("a", "body").file("a/b", "body")), "R2W0224");
  EXPECT_EQ(code(RawTar().file("a", "body").add("a", '2', {}, "b")), "R2W0224");
  ZipWriter twice;
  const std::string part = zstd_compressed(RawTar().file("a", "body").bytes(), 3);
  twice.member("info-x-1-0.tar.zst", zstd_compressed(good_info().bytes(), 3));
  twice.member("pkg-x-1-0.tar.zst", part);
  twice.member("pkg-y-1-0.tar.zst", part);
  EXPECT_EQ(code(twice.finish()), "R2W0224");
}

// Guarantee, hostile input: archives: bombs, by size, number and ratio
TEST_F(HostileArchive, Bombs) {
  const std::string zeros(4U << 20U, '\0');
  const std::string bomb = conda(RawTar().file("a", zeros),
                                 RawTar().file("info/paths.json", paths_json({{"a", zeros}})));
  EXPECT_EQ(code(bomb), "unpacked");
  EXPECT_EQ(code(bomb, {.total_bytes = 1U << 20U}), "R2W0225");
  EXPECT_EQ(code(bomb, {.ratio = 10, .ratio_from_bytes = 1U << 20U}), "R2W0225");
  EXPECT_EQ(code(bomb, {.members = 1}), "R2W0225");
}

TEST_F(HostileArchive, FilesThatAreNotListedOrDiffer) {
  EXPECT_EQ(code(RawTar().file("a", "b0dy")), "R2W0226");
  EXPECT_EQ(code(RawTar().file("a", "longer body")), "R2W0226");
  EXPECT_EQ(code(RawTar().file("b", "body")), "R2W0226");
  EXPECT_EQ(code(RawTar().file("a", "body").file("more", "body")), "R2W0226");
  EXPECT_EQ(code(RawTar()), "R2W0226");
}

TEST_F(HostileArchive, DamagedOnes) {
  const std::string good = conda(RawTar().file("a", "body"), good_info());
  EXPECT_EQ(code(""), "R2W0221");
  EXPECT_EQ(code("not a zip"), "R2W0221");
  EXPECT_EQ(code(good.substr(0, good.size() / 2)), "R2W0221");
  EXPECT_EQ(code(conda(RawTar().file("a", "body"), RawTar().file("info/index.json", "{}"))),
            "R2W0221");
  EXPECT_EQ(code(conda(RawTar().file("a", "body"), RawTar().file("info/paths.json", "{}"))),
            "R2W0221");
  EXPECT_EQ(code(conda(RawTar().file("a", "body"),
                       RawTar().file("info/paths.json",
                                     R"({"paths":[{"_path":"../x","path_type":"hardlink"}]})"))),
            "R2W0221");
  std::string flipped = good;
  for (std::size_t at = 40; at < good.size(); at += 7) {  // any one byte
    flipped = good;
    flipped[at] = static_cast<char>(flipped[at] ^ 0x55);
    code(flipped);  // no crash, nothing outside; some bytes mean nothing
  }
}

TEST(LinkRules, LinkScripts) {
  EXPECT_EQ(link_script_package("bin/.x-post-link.sh"), "x");
  EXPECT_EQ(link_script_package("bin/.a-b-pre-link.sh"), "a-b");
  EXPECT_EQ(link_script_package("bin/.x-pre-unlink.sh"), "x");
  EXPECT_EQ(link_script_package("Scripts/.x-post-link.bat"), "x");
  EXPECT_EQ(link_script_package("python-scripts/.x-post-link.sh"), "x");  // bin/ once installed
  for (const char* other : {"bin/x-post-link.sh", "bin/.x-post-link.py", "lib/.x-post-link.sh",
                            "bin/.-post-link.sh", "bin/.x.sh", ".x-post-link.sh"})
    EXPECT_EQ(link_script_package(other), std::nullopt) << other;
}

TEST(LinkRules, Names) {
  EXPECT_EQ(safe_member_path("./a//b/"), "a/b");
  EXPECT_EQ(safe_member_path("a/./b"), "a/b");
  for (const char* bad : {"", ".", "/a", "../a", "a/../b", "a\tb"})
    EXPECT_EQ(safe_member_path(bad), std::nullopt) << bad;
  EXPECT_TRUE(link_stays_inside("a/b/l", "../../x"));
  EXPECT_FALSE(link_stays_inside("a/b/l", "../../../x"));
  EXPECT_TRUE(link_stays_inside("l", "x/y"));
  EXPECT_FALSE(link_stays_inside("a/l", "x/../y"));
}

}  // namespace
}  // namespace ros2wasm
