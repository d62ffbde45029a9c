// Indexes that are scanned once and kept: the same records as from a full parse, whatever happens
// to the kept file.
#include "bundler/channel/repodata_index.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <random>

#include "bundler/archive/zstd.hpp"
#include "bundler/channel/repodata_scan.hpp"
#include "unit/bundler/support/small_channel.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;
using testing::TemporaryTree;

/// More than what is scanned anew each time; `count` records of a quarter as many names.
std::string large_index(int count, const std::string& version = "1") {
  std::string text = "{\"info\": {\"subdir\": \"noarch\"},\n \"packages.conda\": {";
  for (int i = 0; i < count; ++i) {
    const std::string name = "p" + std::to_string(i / 4);
    const std::string file = name + "-" + version + "-" + std::to_string(i % 4) + ".conda";
    const std::string next = "p" + std::to_string(i / 4 + 1);
    text += (i == 0 ? "" : ",") + ("\n\"" + file + "\": {\"build\": \"" + std::to_string(i % 4)) +
            "\", \"build_number\": " + std::to_string(i % 4) + ", \"depends\": [\"" +
            (i / 4 % 10 == 9 ? "__unix" : next) + "\"], \"license\": \"MIT \\\"x\\\" {[\", " +
            "\"name\": \"" + name + "\", \"version\": \"" + version + "\"}";
  }
  return text + "}, \"packages\": {}, \"removed\": [\"p0-" + version + "-3.conda\"]}\n";
}

struct Scan {
  std::vector<std::string> found;
  std::optional<std::string> fault;
};

Scan scanned(std::string_view text, std::size_t piece) {
  Scan scan;
  RepodataScanner scanner([&](const FoundRecord& found) {
    EXPECT_EQ(text.substr(found.offset, found.text.size()), found.text);
    scan.found.push_back(std::string(found.name) + (found.conda ? "+" : "-") +
                         std::string(found.text));
  });
  for (std::size_t at = 0; at < text.size() && !scan.fault; at += piece)
    scan.fault = scanner.feed(text.substr(at, piece));
  if (!scan.fault) scan.fault = scanner.finish();
  return scan;
}

TEST(RepodataScan, ThePiecesDoNotMatter) {
  const std::string text = large_index(40);
  const Scan whole = scanned(text, text.size());
  EXPECT_FALSE(whole.fault);
  EXPECT_EQ(whole.found.size(), 40U);
  for (const std::size_t piece : {1, 2, 7, 64, 1000}) {
    const Scan scan = scanned(text, piece);
    EXPECT_FALSE(scan.fault) << piece;
    EXPECT_EQ(scan.found, whole.found) << piece;
  }
}

// Guarantee, hostile input: an index of a channel that was cut anywhere is refused
TEST(RepodataScan, EveryCutTextIsAFault) {
  const std::string text = large_index(3);
  for (std::size_t size = 1; size + 2 < text.size(); ++size)
    EXPECT_TRUE(scanned(std::string_view(text).substr(0, size), 13).fault) << size;
  EXPECT_TRUE(scanned(text + "x", 13).fault);
  EXPECT_FALSE(scanned("", 13).fault);
}

/// A channel folder with one large index, and its cache.
class KeptIndexTest : public ::testing::Test {
 protected:
  void write(const std::string& text) const {
    const fs::path beside = tree_.write("c/noarch/new", zstd_compressed(text, 1));
    fs::rename(beside, tree_ / "c/noarch/repodata.json.zst");
  }

  [[nodiscard]] RepoIndex read(const std::vector<std::string>& specs) const {
    const std::vector<ChannelSource> sources{{.name = "./c", .span = {}}};
    const auto open = open_channels(
        sources, {.working_directory = tree_.root(), .embedded = {}, .cache = tree_ / "cache"});
    EXPECT_TRUE(open.ok());
    if (!open) return {};
    auto index = open->reachable(specs, ChannelPriority::kStrict);
    EXPECT_TRUE(index.ok());
    return index.ok() ? std::move(*index) : RepoIndex{};
  }

  [[nodiscard]] std::vector<fs::path> kept() const {
    std::vector<fs::path> files;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(tree_ / "cache/index", error))
      files.push_back(entry.path());
    return files;
  }

  void expect_all_is_well(const std::string& version) const {
    const RepoIndex index = read({"p0"});
    EXPECT_EQ(index.names().size(), 2500U);
    ASSERT_EQ(index.records.size(), 39U);  // p0 to p9, less the one that was removed
    for (const PackageRecord& record : index.records) EXPECT_EQ(record.version, version);
    EXPECT_EQ(index.records[0].url, "./c/noarch/p0-" + version + "-0.conda");
    EXPECT_EQ(index.records[0].license, "MIT \"x\" {[");
    EXPECT_TRUE(index.left_out.empty());
  }

  TemporaryTree tree_;
};

constexpr int kRecords = 10'000;

TEST_F(KeptIndexTest, IsWrittenOnceAndUsed) {
  write(large_index(kRecords));
  expect_all_is_well("1");
  ASSERT_EQ(kept().size(), 1U);
  const auto written = fs::last_write_time(kept()[0]);
  expect_all_is_well("1");
  EXPECT_EQ(fs::last_write_time(kept()[0]), written);
}

TEST_F(KeptIndexTest, AChangedSourceCounts) {
  write(large_index(kRecords));
  expect_all_is_well("1");
  write(large_index(kRecords, "2"));
  expect_all_is_well("2");
  EXPECT_EQ(kept().size(), 1U);
}

TEST_F(KeptIndexTest, DamageIsSeenAndMendedWhereverItIs) {
  write(large_index(kRecords));
  expect_all_is_well("1");
  const std::string name = fs::relative(kept().at(0), tree_.root()).string();
  const std::string good = tree_.read(name);
  std::mt19937 random(11);
  std::vector<std::size_t> places{0, 20, 60, 128, 300, good.size() - 1};
  for (int i = 0; i < 30; ++i) places.push_back(random() % good.size());
  for (const std::size_t place : places) {
    std::string bad = good;
    bad[place] = static_cast<char>(bad[place] ^ 0x11);
    tree_.write(name, bad);
    SCOPED_TRACE(place);
    expect_all_is_well("1");
  }
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{100}, good.size() / 2, good.size() - 1}) {
    tree_.write(name, good.substr(0, size));
    SCOPED_TRACE(size);
    expect_all_is_well("1");
  }
}

TEST_F(KeptIndexTest, WithoutACacheItIsMadeInMemory) {
  write(large_index(kRecords));
  tree_.write("cache", "a file where the folder should be");
  expect_all_is_well("1");
}

TEST_F(KeptIndexTest, ADamagedSourceIsAnErrorAndKeepsNothing) {
  const std::string text = large_index(kRecords);
  write(text.substr(0, text.size() / 2));
  const std::vector<ChannelSource> sources{{.name = "./c", .span = {}}};
  const auto open = open_channels(
      sources, {.working_directory = tree_.root(), .embedded = {}, .cache = tree_ / "cache"});
  ASSERT_FALSE(open.ok());
  EXPECT_EQ(open.errors().front().code.text(), "R2W0202");
  EXPECT_TRUE(kept().empty());
}

TEST(OpenChannels, ReachesWhatTheRequestCanNeed) {
  const TemporaryTree tree;
  const auto record = [](const std::string& name, const std::string& depends) {
    return "\"" + name + "-1-0.conda\":{\"name\":\"" + name +
           "\",\"version\":\"1\",\"build\":\"0\",\"depends\":[" + depends + "]}";
  };
  tree.write("one/noarch/repodata.json", "{\"packages.conda\":{" + record("a", "\"b >=1\",\"x*\"") +
                                             "," + record("other", "") + "}}");
  tree.write("two/noarch/repodata.json", "{\"packages.conda\":{" + record("a", "\"never\"") + "," +
                                             record("b", "\"__unix\"") + "," + record("x1", "") +
                                             "," + record("never", "") + "}}");
  const std::vector<ChannelSource> sources{{.name = "one", .span = {}},
                                           {.name = "two", .span = {}}};
  const auto open =
      open_channels(sources, {.working_directory = tree.root(), .embedded = {}, .cache = {}});
  ASSERT_TRUE(open.ok());
  EXPECT_EQ(open->names(), (std::vector<std::string>{"a", "b", "never", "other", "x1"}));
  const auto urls = [&](const std::vector<std::string>& specs, ChannelPriority priority) {
    std::string text;
    const auto index = open->reachable(specs, priority);
    for (const PackageRecord& one : index->records) text += one.channel + ":" + one.name + " ";
    return text;
  };
  EXPECT_EQ(urls({"a"}, ChannelPriority::kStrict), "one:a two:b two:x1 ");
  EXPECT_EQ(urls({"a"}, ChannelPriority::kFlexible), "one:a two:a two:b two:never two:x1 ");
  EXPECT_EQ(urls({"two::a"}, ChannelPriority::kStrict), "one:a two:a two:b two:never two:x1 ");
  EXPECT_EQ(urls({"absent"}, ChannelPriority::kStrict), "");
}

TEST(OpenChannels, SaysWhatOnlyAnotherPlatformHas) {
  const TemporaryTree tree;
  tree.write("c/noarch/repodata.json", "{}");
  tree.write("c/linux-64/repodata.json",
             R"({"packages":{"gpu-1-0.tar.bz2":{"name":"gpu","version":"1","build":"0"}}})");
  const std::vector<ChannelSource> sources{{.name = "c", .span = {}}};
  const auto open =
      open_channels(sources, {.working_directory = tree.root(), .embedded = {}, .cache = {}});
  ASSERT_TRUE(open.ok());
  const auto index =
      open->reachable(std::vector<std::string>{"gpu >=1", "nowhere"}, ChannelPriority::kStrict);
  ASSERT_TRUE(index.ok());
  const auto resolution = solve(testing::request_for({"gpu >=1", "nowhere"}), *index);
  ASSERT_EQ(resolution.errors().size(), 2U);
  EXPECT_EQ(resolution.errors()[0].code, "R2W0302");
  EXPECT_EQ(resolution.errors()[0].why.back(),
            "it is there for linux-64 in c, but has not been built for emscripten-wasm32");
  EXPECT_EQ(resolution.errors()[1].why.back(), "the channels are: c");
}

}  // namespace
}  // namespace ros2wasm
