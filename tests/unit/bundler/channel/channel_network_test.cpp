// Addresses of channels: the alias, variables, credentials that are taken out, mirrors.
#include "bundler/channel/channel_network.hpp"

#include <gtest/gtest.h>

#include "bundler/channel/index_cache.hpp"
#include "workspace_schema/base/secret_text.hpp"

namespace ros2wasm {
namespace {

std::string address(const std::string& text, ChannelNetwork& network) {
  const auto found = channel_address(text, network);
  return found ? *found : found.errors().front().code.text();
}

TEST(ChannelAddress, NamesFoldersAndAddresses) {
  ChannelNetwork network = network_of({{"TOKEN", "abc"}});
  EXPECT_EQ(address("conda-forge", network), "R2W0240");
  network.alias = "https://my.host/conda//";
  EXPECT_EQ(address("a/label/dev/", network), "https://my.host/conda/a/label/dev");
  EXPECT_EQ(address("a", network), "https://my.host/conda/a");
  for (const char* same : {"embedded", "./a", "../a", "/a", "file:///a", "https://host/a"})
    EXPECT_EQ(address(same, network), same);
  EXPECT_EQ(address("https://host/${TOKEN}/a", network), "https://host/abc/a");
  EXPECT_EQ(address("https://host/${ABSENT}/a", network), "R2W0237");
  EXPECT_TRUE(network.secrets.empty());
}

TEST(ChannelAddress, CredentialsGoToTheRequestsBelowOnly) {
  ChannelNetwork network = network_of({{"ROS2WASM_AUTH_OTHER_HOST", "token xyz"}});
  EXPECT_EQ(address("https://u:p@host/a", network), "https://host/a");
  EXPECT_EQ(address("https://host/t/tok-1/a/b", network), "https://host/a/b");
  const auto first = sources_of("https://host/a/noarch/x.conda", network).front();
  EXPECT_EQ(first.user_info, "u:p");
  EXPECT_EQ(first.url, "https://host/a/noarch/x.conda");
  const auto second = sources_of("https://host/a/b/noarch/x.conda", network).front();
  EXPECT_EQ(second.url, "https://host/t/tok-1/a/b/noarch/x.conda");
  EXPECT_EQ(second.shown_url, "https://host/a/b/noarch/x.conda");
  EXPECT_TRUE(second.user_info.empty());
  EXPECT_TRUE(sources_of("https://host/ab/x.conda", network).front().user_info.empty());
  EXPECT_EQ(sources_of("https://other.host/c/x", network).front().url,
            "https://other.host/t/xyz/c/x");
}

// Guarantee, hostile input: a host's credentials go to it alone, over `https://` or to this machine
TEST(ChannelAddress, AHostsCredentialsAreForItAloneAndOverPrivateWays) {
  const auto bearer = [](const std::string& variable, const std::string& url) {
    return sources_of(url, network_of({{"ROS2WASM_AUTH_" + variable, "xyz"}})).front().bearer;
  };
  EXPECT_EQ(bearer("CONDA_CORP_COM", "https://conda.corp.com/a"), "xyz");
  EXPECT_EQ(bearer("CONDA_CORP_COM", "https://conda-corp.com/a"), "");
  EXPECT_EQ(bearer("CONDA__CORP_COM", "https://conda-corp.com:8443/a"), "xyz");
  EXPECT_EQ(bearer("CONDA_CORP_COM", "https://conda_corp.com/a"), "");
  EXPECT_EQ(bearer("CONDA___CORP_COM", "https://conda_corp.com/a"), "xyz");
  EXPECT_EQ(bearer("CONDA_CORP_COM", "http://conda.corp.com/a"), "");
  EXPECT_EQ(bearer("127_0_0_1", "http://127.0.0.1:80/a"), "xyz");
  EXPECT_EQ(bearer("LOCALHOST", "http://localhost/a"), "xyz");
  EXPECT_EQ(bearer("127_EVIL_COM", "http://127.evil.com/a"), "");
}

TEST(ChannelAddress, MirrorsComeFirst) {
  ChannelNetwork network;
  network.mirrors = {{.base = "https://host/a", .urls = {"https://m1/x", "https://m2/y"}}};
  std::string urls;
  for (const DownloadSource& source : sources_of("https://host/a/noarch/r", network))
    urls += source.url + " ";
  EXPECT_EQ(urls, "https://m1/x/noarch/r https://m2/y/noarch/r https://host/a/noarch/r ");
  EXPECT_EQ(sources_of("https://host/ab/r", network).size(), 1U);
  network.mirrors.front().urls = {"/srv/a"};
  EXPECT_EQ(at_mirrors("https://host/a/noarch/r", network),
            std::vector<std::string>{"/srv/a/noarch/r"});
  EXPECT_EQ(sources_of("https://host/a/noarch/r", network).size(), 1U);
  // An index says where its archives are, but not which files of this machine they are.
  EXPECT_TRUE(at_mirrors("https://host/a/noarch/../../etc/r", network).empty());
}

TEST(SecretText, MasksKeepPlacesAndLeaveTheRest) {
  EXPECT_EQ(with_masked_secrets("at https://u:p@h/x and \"ftp://q@h\""),
            "at https://***@h/x and \"ftp://*@h\"");
  EXPECT_EQ(with_masked_secrets("https://h/t/abc-1/x?a=/t/z"), "https://h/t/*****/x?a=/t/z");
  for (const char* same : {"no address", "https://h/a@b", "a://", "://", "https://h/t/", "/t/abc/",
                           "file:///t/abc/x", "FILE:///home/t/abc"})
    EXPECT_EQ(with_masked_secrets(same), same);
  EXPECT_EQ(without_secrets("https://u:p@h:1/t/abc/x"), "https://h:1/x");
  EXPECT_EQ(without_secrets("https://h/t/abc"), "https://h");
  EXPECT_EQ(without_secrets("/t/abc/x"), "/t/abc/x");
  EXPECT_EQ(without_secrets("file:///home/t/abc/x"), "file:///home/t/abc/x");
  EXPECT_EQ(without_secrets("profile://h/t/abc/x"), "profile://h/x");
}

TEST(IndexCopyState, RoundTripAndDamage) {
  const IndexCopyState state{.url = "https://h/r",
                             .etag = "\"x\"",
                             .last_modified = "then",
                             .sha256 = std::string(64, 'a'),
                             .checked_s = 5};
  const auto read = read_copy_state(write_copy_state(state));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->etag, state.etag);
  EXPECT_EQ(read->checked_s, 5);
  for (const char* bad : {"", "[]", "{}", R"({"url":"x","sha256":"12","checked":1})"})
    EXPECT_FALSE(read_copy_state(bad)) << bad;
}

}  // namespace
}  // namespace ros2wasm
