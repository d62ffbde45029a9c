// Tests that files made from a package are not sources of it.
#include "bundler/build/source_tree.hpp"

#include <gtest/gtest.h>

#include "bundler/archive/zip_writer.hpp"
#include "bundler/io/files.hpp"
#include "bundler/render/site_json.hpp"

namespace ros2wasm {
namespace {

std::string archive_of(std::string_view name, std::string_view text) {
  ZipWriter archive;
  archive.member(name, text);
  archive.member("index.html", "<!doctype html>");
  return archive.finish();
}

TEST(SourceTree, HasNoSitesOfOurs) {
  const auto scratch = TemporaryDirectory::make(::testing::TempDir(), "sources-");
  ASSERT_TRUE(scratch);
  const auto& folder = scratch->path();
  const std::string ours = "{\"generator\": \"" + std::string(kSiteGenerator) + " 9.9.9\"}";
  const std::pair<const char*, std::string> files[] = {
      {"package.xml", "<package/>"},
      {"site.zip", archive_of("site.json", ours)},
      {"site/site.json", ours},
      // Archives and lists of other tools are sources, and so are files that only have such a name.
      {"meshes.zip", archive_of("arm.stl", "solid")},
      {"other.zip", archive_of("site.json", R"({"generator": "a press"})")},
      {"short.zip", archive_of("site.json", ours).substr(0, 50)},
      {"site.bin", archive_of("site.json", ours)},
      {"text.zip", "no archive"},
  };
  for (const auto& [name, bytes] : files) ASSERT_TRUE(write_file(folder / name, bytes));
  const auto found = source_tree(folder);
  ASSERT_TRUE(found);
  std::vector<std::string> names;
  for (const SourceEntry& one : *found) names.push_back(one.path);
  EXPECT_EQ(names, (std::vector<std::string>{".", "meshes.zip", "other.zip", "package.xml",
                                             "short.zip", "site.bin", "text.zip"}));
}

}  // namespace
}  // namespace ros2wasm
