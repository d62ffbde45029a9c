// Reading indexes: the forms that real channels have, and what is skipped with a reason.
#include "bundler/channel/channel_index.hpp"

#include <gtest/gtest.h>

#include "bundler/archive/zstd.hpp"
#include "bundler/channel/repodata_index.hpp"
#include "bundler/channel/transport.hpp"
#include "unit/bundler/support/small_channel.hpp"

namespace ros2wasm {
namespace {

RepoIndex parsed(const std::string& packages, const std::string& rest = {}) {
  auto index =
      parse_repodata("{\"packages.conda\":{" + packages + "}" + rest + "}", "chan", "noarch");
  EXPECT_TRUE(index.ok());
  return index.ok() ? std::move(*index) : RepoIndex{};
}

TEST(Repodata, ManyFormsOfFields) {
  const RepoIndex index = parsed(
      R"("a-1-0.conda":{"name":"A","version":"1","build":"0","build_number":0,"noarch":true,"track_features":"x, y","timestamp":1500000000,"depends":["b","b"],"sha256":null,"size":3,"run_exports":{"weak":["a >=1"]}},
         "c-1-0.conda":{"name":"c","version":"1","build":"0","build_number":0,"noarch":"python","track_features":["z"],"timestamp":1500000000000,"constrains":null,"subdir":"noarch","run_exports":7},
         "d-1-0.conda":{"name":"d","version":"1","build":"0","build_number":0,"noarch":"","md5":"D41D8CD98F00B204E9800998ECF8427E"})");
  ASSERT_EQ(index.records.size(), 3U);
  EXPECT_EQ(index.records[0].name, "a");
  EXPECT_EQ(index.records[0].noarch, NoarchKind::kGeneric);
  EXPECT_EQ(index.records[0].track_features, (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(index.records[0].timestamp_ms, 1'500'000'000'000);
  EXPECT_EQ(index.records[0].depends, std::vector<std::string>{"b"});
  EXPECT_EQ(index.records[0].url, "chan/noarch/a-1-0.conda");
  EXPECT_EQ(index.records[1].noarch, NoarchKind::kPython);
  EXPECT_EQ(index.records[1].timestamp_ms, 1'500'000'000'000);
  EXPECT_EQ(index.records[2].noarch, NoarchKind::kNo);
  EXPECT_EQ(index.records[2].md5, "d41d8cd98f00b204e9800998ecf8427e");
}

TEST(Repodata, BadRecordsAreLeftOutWithAReason) {
  const RepoIndex index = parsed(
      R"("a-1-0.conda":{"name":"a","version":"1","build":"0"},
         "b-1-0.conda":{"name":"b","version":"1","build":"0","depends":["ray[default"]},
         "c-1-0.conda":{"name":"c","version":"1","build":"0","depends":["x >="]},
         "d-1-0.conda":{"name":"d","version":"1..2","build":"0"},
         "e-1-0.conda":{"name":"../e","version":"1","build":"0"},
         "../f-1-0.conda":{"name":"f","version":"1","build":"0"},
         "g-1-0.conda":{"name":"g","version":"1","build":"0","noarch":"other"},
         "h-1-0.conda":{"name":"h","version":"1","build":"0","sha256":"12"},
         "i-1-0.conda":7,
         "j-1-0.conda":{"name":"j","version":"1","build":"0","size":-1},
         "k-1-0.zip":{"name":"k","version":"1","build":"0"},
         "l-1-0.conda":{"name":"l","version":"1","build":"0","depends":"x"})");
  ASSERT_EQ(index.records.size(), 1U);
  EXPECT_EQ(index.records[0].name, "a");
  EXPECT_EQ(index.left_out.size(), 11U);
  for (const LeftOutRecord& record : index.left_out)
    EXPECT_FALSE(record.reason.empty()) << record.file_name;
}

// Guarantee, hostile input: a record with more dependencies than any package has is skipped, and
// does not hold up the others
TEST(Repodata, ARecordHasALimitOfDependencies) {
  const auto record = [](int count) {
    std::string specs;
    for (int i = 0; i < count; ++i) specs += (i == 0 ? "\"q" : ",\"q") + std::to_string(i) + "\"";
    return R"({"name":"a","version":"1","build":"0","depends":[)" + specs + "]}";
  };
  EXPECT_EQ(parsed("\"a-1-0.conda\":" + record(10'000)).records.size(), 1U);
  const RepoIndex index = parsed("\"a-1-0.conda\":" + record(10'001));
  ASSERT_EQ(index.left_out.size(), 1U);
  EXPECT_EQ(index.left_out[0].reason, "`depends` has more than 10000 items");
}

TEST(Repodata, CondaIsPreferredAndRemovedIsLeftOut) {
  const std::string record = R"({"name":"a","version":"1","build":"0"})";
  const RepoIndex index =
      parsed("\"a-1-0.conda\":" + record + ",\"a-1-1.conda\":" + record,
             ",\"packages\":{\"a-1-0.tar.bz2\":" + record + ",\"a-1-2.tar.bz2\":" + record +
                 "},\"removed\":[\"a-1-1.conda\"]");
  ASSERT_EQ(index.records.size(), 2U);
  EXPECT_EQ(index.records[0].file_name, "a-1-0.conda");
  EXPECT_EQ(index.records[1].file_name, "a-1-2.tar.bz2");
}

TEST(Repodata, BaseUrl) {
  const std::string packages = R"("a-1-0.conda":{"name":"a","version":"1","build":"0"})";
  EXPECT_EQ(parsed(packages, R"(,"info":{"base_url":"https://other/x/"})").records[0].url,
            "https://other/x/a-1-0.conda");
  EXPECT_EQ(parsed(packages, R"(,"info":{"base_url":"../y"})").records[0].url,
            "chan/noarch/../y/a-1-0.conda");
}

TEST(Repodata, DamagedTextsAreErrorsAndEmptyOnesAreEmpty) {
  EXPECT_TRUE(parse_repodata("", "chan", "noarch").ok());
  EXPECT_TRUE(parse_repodata("{}", "chan", "noarch").ok());
  for (const char* text : {"{", "[]", "7", "{\"packages\":}", "\xff"}) {
    const auto index = parse_repodata(text, "chan", "noarch");
    ASSERT_FALSE(index.ok()) << text;
    EXPECT_EQ(index.errors().front().code.text(), "R2W0202");
  }
  EXPECT_FALSE(parse_repodata(std::string(100'000, '['), "chan", "noarch").ok());
}

constexpr const char* kOne =
    R"({"packages.conda":{"a-1-0.conda":{"name":"a","version":"1","build":"0"}}})";

std::string load_code(const std::string& channel, const ChannelRoots& roots) {
  const std::vector<ChannelSource> sources{{.name = channel, .span = {}}};
  const auto index = load_channels(sources, roots);
  if (!index) return index.errors().front().code.text();
  return std::to_string(index->records.size()) + " " +
         (index->records.empty() ? "" : index->records[0].url);
}

TEST(LoadChannels, FoldersFileAddressesAndTheEmbeddedOne) {
  const testing::TemporaryTree tree;
  tree.write("my chan/noarch/repodata.json", kOne);
  const ChannelRoots roots{
      .working_directory = tree.root(), .embedded = tree / "my chan", .cache = tree / "cache"};
  EXPECT_EQ(load_code("./my chan/", roots), "1 ./my chan/noarch/a-1-0.conda");
  EXPECT_EQ(load_code((tree / "my chan").string(), roots),
            "1 " + (tree / "my chan").string() + "/noarch/a-1-0.conda");
  EXPECT_EQ(load_code("file://" + tree.root().string() + "/my%20chan", roots),
            "1 file://" + tree.root().string() + "/my%20chan/noarch/a-1-0.conda");
  EXPECT_EQ(load_code("embedded", roots), "1 embedded:/noarch/a-1-0.conda");
  EXPECT_EQ(load_code("./absent", roots), "R2W0201");
  EXPECT_EQ(load_code("gopher://x/y", roots), "R2W0203");
}

TEST(LoadChannels, TheCompressedIndexWinsAndDamageIsSaid) {
  const testing::TemporaryTree tree;
  tree.write("c/noarch/repodata.json", "{}");
  tree.write("c/noarch/repodata.json.zst", zstd_compressed(kOne, 3));
  const ChannelRoots roots{
      .working_directory = tree.root(), .embedded = {}, .cache = tree / "cache"};
  EXPECT_EQ(load_code("c", roots), "1 c/noarch/a-1-0.conda");
  tree.write("c/noarch/repodata.json.zst", zstd_compressed(kOne, 3).substr(0, 20));
  EXPECT_EQ(load_code("c", roots), "R2W0202");
  tree.write("c/noarch/repodata.json.zst", "not zstd");
  EXPECT_EQ(load_code("c", roots), "R2W0202");
}

TEST(LoadChannels, AllMissingChannelsAtOnce) {
  const testing::TemporaryTree tree;
  const ChannelRoots roots{
      .working_directory = tree.root(), .embedded = {}, .cache = tree / "cache"};
  const std::vector<ChannelSource> sources{{.name = "one", .span = {}},
                                           {.name = "two", .span = {}}};
  const auto index = load_channels(sources, roots);
  ASSERT_FALSE(index.ok());
  EXPECT_EQ(index.errors().size(), 2U);
}

TEST(EmbeddedChannel, IsFoundBesideTheProgramAndAfterInstallation) {
  const testing::TemporaryTree tree;
  EXPECT_EQ(embedded_channel(tree / "bin/ros2wasm").errors().front().code.text(), "R2W0204");
  tree.write("share/ros2wasm/channel/noarch/repodata.json", "{}");
  EXPECT_EQ(*embedded_channel(tree / "bin/ros2wasm"), tree / "share/ros2wasm/channel");
  tree.write("bin/channel/noarch/repodata.json", "{}");
  EXPECT_EQ(*embedded_channel(tree / "bin/ros2wasm"), tree / "bin/channel");
}

TEST(Transports, EachSchemeHasOneRow) {
  for (const Transport& row : transports()) {
    EXPECT_EQ(std::count_if(transports().begin(), transports().end(),
                            [&](const Transport& other) { return other.scheme == row.scheme; }),
              1);
  }
}

}  // namespace
}  // namespace ros2wasm
