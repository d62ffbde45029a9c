// Which files `serve` answers with: whatever a site says of itself, none but those of a site and of
// a store.
#include "bundler/serve/served_place.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <thread>

#include "bundler/io/sha256.hpp"
#include "bundler/serve/site_policy.hpp"
#include "bundler/serve/site_responder.hpp"
#include "bundler/site/site_place.hpp"
#include "tests/unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

const std::string kObject(64, 'a');
const std::string kScripts(64, 'b');

/// site.json of a site that says that its store is there.
std::string site_with(const std::string& objects) {
  return R"({"generator":"ros2wasm 0.1.0","store":{"objects":")" + objects + R"(","scripts":")" +
         kScripts + R"("},"files":[]})";
}

/// A site in lab/one, a store in lab/objects with an object and a folder of scripts, and secrets.
class ServedStore : public ::testing::Test {
 protected:
  void SetUp() override {
    tree_.write("lab/one/site.json", site_with("../objects/"));
    tree_.write("lab/one/index.html", "page");
    tree_.write("lab/objects/" + kObject + ".wasm", "object");
    tree_.write("lab/objects/" + kScripts + "/start.js", "script");
    tree_.write("lab/objects/secret.txt", "secret");
    tree_.write("lab/other/index.html", "secret");
    tree_.write("secret.txt", "secret");
  }

  void prove_store() { tree_.write("lab/objects/store.json", std::string(kStoreMarkerText)); }

  /// The text that is found at a path below the site `lab/one`, or "folder" or "nothing".
  [[nodiscard]] std::string found(const std::string& path) const {
    const Found file = find_served(served_place(tree_ / "lab/one"), path);
    if (file.kind == Lookup::kFolder) return "folder";
    if (file.kind == Lookup::kNothing) return "nothing";
    return tree_.read(file.path.lexically_relative(fs::canonical(tree_.root())).string());
  }

  testing::TemporaryTree tree_;
};

TEST_F(ServedStore, AStoreThatPackMadeGivesItsObjects) {
  prove_store();
  const ServedPlace place = served_place(tree_ / "lab/one");
  EXPECT_EQ(place.address, "one/");
  EXPECT_EQ(place.store_address, "objects/");
  EXPECT_FALSE(place.warning);
  EXPECT_EQ(found("one/index.html"), "page");
  EXPECT_EQ(found("one"), "folder");
  EXPECT_EQ(found("objects/" + kObject + ".wasm"), "object");
  EXPECT_EQ(found("objects/" + kScripts + "/start.js"), "script");
}

// Guarantee, hostile input: links out of a served site or its store, folders beside them and other
// files in the store are not served
TEST_F(ServedStore, NothingElseBesideTheSiteOrInTheStoreIsFound) {
  prove_store();
  fs::create_symlink("../../secret.txt", tree_ / ("lab/objects/" + kObject + ".txt"));
  fs::create_symlink("../../secret.txt", tree_ / "lab/one/link.txt");
  fs::create_directory_symlink("../..", tree_ / ("lab/objects/" + std::string(64, 'c')));
  for (const std::string& path :
       {std::string("objects/secret.txt"), std::string("objects/store.json"),
        std::string("other/index.html"), std::string("secret.txt"), std::string(""),
        std::string("index.html"), "objects/" + kObject + ".txt", std::string("one/link.txt"),
        "objects/" + std::string(64, 'c') + "/secret.txt", "objects/" + kObject.substr(1),
        std::string("one@0123456789abcdef/index.html")})
    EXPECT_EQ(found(path), "nothing") << path;
}

TEST_F(ServedStore, AFolderWithoutTheMarkerIsNotAStoreWhateverItsNames) {
  fs::remove(tree_ / "lab/objects/secret.txt");
  EXPECT_EQ(found("index.html"), "page");
  EXPECT_EQ(found("objects/" + kObject + ".wasm"), "nothing");
  EXPECT_EQ(served_place(tree_ / "lab/one").warning->code, "R2W0613");
}

TEST_F(ServedStore, ASiteCannotNameAnotherFolderAsItsStore) {
  for (const char* objects :
       {"../../", "../../lab/", "../other/", "../absent/", "../../../../../../../../etc/"}) {
    tree_.write("lab/one/site.json", site_with(objects));
    EXPECT_EQ(found("index.html"), "page") << objects;
    for (const char* path :
         {"secret.txt", "etc/passwd", "other/index.html", "lab/other/index.html"})
      EXPECT_EQ(found(path), "nothing") << objects << path;
  }
  // One with a marker of its own gives what a store gives.
  tree_.write("lab/other/store.json", std::string(kStoreMarkerText));
  tree_.write("lab/one/site.json", site_with("../other/"));
  EXPECT_EQ(found("other/index.html"), "nothing");
  EXPECT_EQ(found("secret.txt"), "nothing");
  // A marker is a file with the bytes that `pack` writes.
  fs::create_symlink("../objects/store.json", tree_ / "lab/one/store.json");
  tree_.write("lab/other/store.json", "{}");
  EXPECT_EQ(served_place(tree_ / "lab/one").warning->code, "R2W0613");
}

TEST_F(ServedStore, AnEarlierPackIsFoundByTheHashOfItsBytes) {
  prove_store();
  const std::string text = site_with("../objects/") + " ";
  const std::string name = "one@" + sha256_hex(text).substr(0, 16);
  tree_.write("lab/" + name + "/site.json", text);
  tree_.write("lab/" + name + "/index.html", "earlier");
  tree_.write("lab/one@0123456789abcdef/index.html", "secret");
  tree_.write("lab/one@0123456789abcdef/site.json", text);
  EXPECT_EQ(found(name + "/index.html"), "earlier");
  EXPECT_EQ(found(name), "folder");
  EXPECT_EQ(found("one@0123456789abcdef/index.html"), "nothing");
  fs::remove_all(tree_ / "lab/one@0123456789abcdef");
  fs::rename(tree_ / ("lab/" + name), tree_ / "lab/real");
  fs::create_directory_symlink("real", tree_ / ("lab/" + name));
  EXPECT_EQ(found(name + "/index.html"), "nothing") << "a link is not a pack";
}

/// The bytes that are read through the descriptor that a lookup has opened.
std::string bytes_of(const Found& found) {
  if (found.kind != Lookup::kFile) return "nothing";
  std::string text(64, '\0');
  const ssize_t got = pread(*found.file, text.data(), text.size(), 0);
  return text.substr(0, static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
}

// Guarantee, hostile input: a site's folder, or its store, that becomes a link or another folder
// while it is served gives nothing else of the disk
TEST_F(ServedStore, WhatTakesThePlaceOfAFolderIsNotServed) {
  prove_store();
  const ServedPlace place = served_place(tree_ / "lab/one");
  tree_.write("swapped/" + kObject + ".wasm", "secret");
  fs::rename(tree_ / "lab/objects", tree_ / "lab/old");
  fs::create_directory_symlink("../swapped", tree_ / "lab/objects");
  EXPECT_EQ(bytes_of(find_served(place, "objects/" + kObject + ".wasm")), "object");
  fs::rename(tree_ / "lab/one", tree_ / "lab/moved");
  fs::create_directory_symlink("..", tree_ / "lab/one");
  EXPECT_EQ(bytes_of(find_served(place, "one/secret.txt")), "nothing");
  fs::remove(tree_ / "lab/one");
  fs::rename(tree_ / "lab", tree_ / "away");
  fs::create_directory_symlink("swapped", tree_ / "lab");
  tree_.write("swapped/one/index.html", "secret");
  EXPECT_EQ(bytes_of(find_served(place, "one/index.html")), "nothing");
  // A new pack is a folder.
  tree_.write("away/one/index.html", "newer");
  EXPECT_EQ(bytes_of(find_served(place, "one/index.html")), "newer");
}

// Guarantee, hostile input: a file that is replaced by a link out of the site between the check and
// the opening is not served
TEST(ServedPlace, AFileThatBecomesALinkMeanwhileIsNeverRead) {
  const testing::TemporaryTree tree;
  tree.write("site/site.json", R"({"files":[]})");
  tree.write("secret.txt", "secret");
  tree.write("plain.txt", "plain");
  const ServedPlace place = served_place(tree / "site");
  std::atomic<bool> stop = false;
  std::thread swapper([&] {
    std::error_code error;
    while (!stop) {
      fs::create_symlink("../secret.txt", tree / "site/next", error);
      fs::rename(tree / "site/next", tree / "site/r.txt", error);
      fs::copy_file(tree / "plain.txt", tree / "site/next", error);
      fs::rename(tree / "site/next", tree / "site/r.txt", error);
    }
  });
  int plain = 0;
  for (int i = 0; i < 20'000 && plain < 2'000; ++i) {
    const std::string text = bytes_of(find_served(place, "r.txt"));
    ASSERT_NE(text, "secret");
    if (text == "plain") ++plain;
  }
  stop = true;
  swapper.join();
  EXPECT_GT(plain, 0);
}

/// The type and the policy with which a file is sent.
std::string sent(const ServedPlace& place, const std::string& target) {
  const SiteServing serving{.place = place, .reload = std::nullopt};
  const HttpRequest request{.method = "GET", .target = target, .header = [](const std::string&) {
                              return std::optional<std::string>();
                            }};
  const HttpResponse response = site_response(serving, request);
  std::string text = std::to_string(response.status) + " " + response.content_type;
  for (const auto& [name, value] : response.headers)
    if (name == "Content-Security-Policy" && value.starts_with("sandbox; ")) text += " sandbox";
  return text;
}

TEST_F(ServedStore, OnlyPagesOfSitesActForTheOrigin) {
  prove_store();
  tree_.write("lab/one/text/lab.html", "of the lab");
  fs::create_symlink("text/lab.html", tree_ / "lab/one/x.bin");
  fs::create_symlink("index.html", tree_ / "lab/one/page.html");
  const std::string text = site_with("../objects/") + " ";
  const std::string earlier = "one@" + sha256_hex(text).substr(0, 16);
  tree_.write("lab/" + earlier + "/site.json", text);
  tree_.write("lab/" + earlier + "/index.html", "earlier");
  tree_.write("lab/" + earlier + "/text/lab.html", "of the lab");
  tree_.write("lab/objects/" + kObject + ".svg", "<svg/>");
  const ServedPlace place = served_place(tree_ / "lab/one");
  EXPECT_EQ(sent(place, "/one/"), "200 text/html; charset=utf-8");
  EXPECT_EQ(sent(place, "/" + earlier + "/"), "200 text/html; charset=utf-8");
  EXPECT_EQ(sent(place, "/" + earlier + "/text/lab.html"), "200 text/html; charset=utf-8 sandbox");
  EXPECT_EQ(sent(place, "/one/text/lab.html"), "200 text/html; charset=utf-8 sandbox");
  EXPECT_EQ(sent(place, "/one/page.html"), "200 text/html; charset=utf-8 sandbox");
  EXPECT_EQ(sent(place, "/one/x.bin"), "200 application/octet-stream");
  EXPECT_EQ(sent(place, "/objects/" + kObject + ".svg"), "200 image/svg+xml sandbox");
}

TEST(StoreNames, AreThoseThatPackGives) {
  const std::string hash(64, '0');
  for (const std::string& name :
       {hash, hash + ".wasm", hash + ".part", hash + ".js.br", hash + ".wasm.Xy12ab"})
    EXPECT_TRUE(is_store_name(name)) << name;
  for (const std::string& name :
       {std::string(), hash.substr(1), hash + "0", hash + ".", hash + "..js", hash + ".a/b",
        hash + ".a.b.c.d", hash + ".abcdefghi", std::string(64, 'A'), hash + "/x",
        std::string("store.json")})
    EXPECT_FALSE(is_store_name(name)) << name;
  EXPECT_TRUE(is_store_path(hash + "/start.js"));
  EXPECT_FALSE(is_store_path(hash + "/"));
  EXPECT_FALSE(is_store_path(hash + ".js/x"));
}

TEST(SitePolicy, IsThatOfThePage) {
  const testing::TemporaryTree tree;
  std::ifstream stream(fs::path(ROS2WASM_SOURCE_DIR) / "runtime/site/ui/index.html");
  const std::string page{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_NE(page.find("content=\"" + std::string(site_policy()) + "\""), std::string::npos);
  EXPECT_TRUE(site_policy().starts_with("default-src 'none'; script-src 'self'"));
}

}  // namespace
}  // namespace ros2wasm
