// The writer: same input, same bytes; what it writes is what the readers read; bad input is
// refused.
#include "bundler/archive/conda_writer.hpp"

#include <gtest/gtest.h>

#include "bundler/archive/package_index.hpp"
#include "bundler/archive/package_listing.hpp"
#include "bundler/archive/package_reader.hpp"
#include "bundler/archive/tar_writer.hpp"
#include "bundler/archive/zip_writer.hpp"
#include "bundler/io/files.hpp"
#include "unit/bundler/support/temporary_tree.hpp"
#include "workspace_schema/base/json_reader.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

CondaPackage package() {
  return {.name = "demo",
          .version = "1.0",
          .build = "h_0",
          .subdir = "noarch",
          .noarch = NoarchKind::kGeneric,
          .depends = {"b >=1", "a"},
          .license = "MIT",
          .summary = "one \"line\"",
          .placeholder = "/build/prefix"};
}

void fill(const testing::TemporaryTree& tree) {
  tree.write("p/bin/tool", "#!/bin/sh\n");
  fs::permissions(tree / "p/bin/tool", fs::perms::owner_exec, fs::perm_options::add);
  tree.write("p/share/text.cmake", "set(X /build/prefix/lib)");
  tree.write("p/share/" + std::string(150, 'n') + "/\xC3\xBC.txt", "long and not ASCII");
  fs::create_directories(tree / "p/share/empty");
  fs::create_symlink("../bin/tool", tree / "p/share/link");
}

TEST(CondaWriter, SameFilesGiveTheSameBytes) {
  const testing::TemporaryTree one;
  const testing::TemporaryTree two;
  fill(one);
  fill(two);
  fs::last_write_time(two / "p/bin/tool",
                      fs::file_time_type::min() + std::chrono::hours(24 * 365 * 60));
  const auto first = write_conda(package(), one / "p");
  const auto second = write_conda(package(), two / "p");
  ASSERT_TRUE(first.ok() && second.ok());
  EXPECT_EQ(*first, *second);
}

TEST(CondaWriter, RoundTrip) {
  const testing::TemporaryTree tree;
  fill(tree);
  const auto bytes = write_conda(package(), tree / "p");
  ASSERT_TRUE(bytes.ok());
  const fs::path archive = tree.write("demo-1.0-h_0.conda", *bytes);
  fs::create_directories(tree / "out");
  const auto unpacked = unpack_package(archive, tree / "out", "demo", {});
  ASSERT_TRUE(unpacked.ok()) << unpacked.errors().front().message
                             << unpacked.errors().front().why.front();
  EXPECT_EQ(tree.read("out/share/text.cmake"), "set(X /build/prefix/lib)");
  EXPECT_EQ(tree.read("out/share/" + std::string(150, 'n') + "/\xC3\xBC.txt"),
            "long and not ASCII");
  EXPECT_TRUE(fs::is_directory(tree / "out/share/empty"));
  EXPECT_EQ(fs::read_symlink(tree / "out/share/link"), "../bin/tool");
  EXPECT_NE(fs::status(tree / "out/bin/tool").permissions() & fs::perms::owner_exec,
            fs::perms::none);
  EXPECT_TRUE(list_package(archive)->faults.empty());

  const auto index = read_index_json(archive, "demo");
  ASSERT_TRUE(index.ok());
  EXPECT_EQ(
      *index,
      R"({"arch":null,"build":"h_0","build_number":0,"constrains":[],"depends":["a","b >=1"],"license":"MIT",)"
      R"("name":"demo","noarch":"generic","platform":null,"subdir":"noarch","version":"1.0"})"
      "\n");
  const auto paths = parse_json(tree.read("out/info/paths.json"), "paths.json", "R2W0221");
  ASSERT_TRUE(paths.ok());
  std::string found;
  for (const JsonValue& item : paths->find("paths")->items()) {
    if (!item.text_of("prefix_placeholder").empty())
      found += item.text_of("_path") + item.text_of("file_mode");
  }
  EXPECT_EQ(found, "share/text.cmaketext");
}

TEST(CondaWriter, EntryPointsOfPython) {
  const testing::TemporaryTree tree;
  tree.write("p/site-packages/demo.py", "def main(): pass");
  CondaPackage python = package();
  python.noarch = NoarchKind::kPython;
  python.entry_points = {"demo = demo:main", "demo-2=a.b_c : D.e"};
  const auto bytes = write_conda(python, tree / "p");
  ASSERT_TRUE(bytes.ok());
  const auto listing = list_package(tree.write("demo-1.0-h_0.conda", *bytes));
  ASSERT_TRUE(listing.ok());
  EXPECT_TRUE(listing->faults.empty());
  EXPECT_EQ(listing->entry_points,
            (std::vector<EntryPoint>{{"demo", "demo", "main"}, {"demo-2", "a.b_c", "D.e"}}));
}

std::string refusal(const CondaPackage& bad, const fs::path& prefix) {
  const auto written = write_conda(bad, prefix);
  return written.ok() ? "written" : written.errors().front().code.text();
}

TEST(CondaWriter, RefusesBadMetadata) {
  const testing::TemporaryTree tree;
  const auto with = [](auto change) {
    CondaPackage changed = package();
    change(changed);
    return changed;
  };
  EXPECT_EQ(refusal(with([](auto& p) { p.name = "../up"; }), tree.root()), "R2W0205");
  EXPECT_EQ(refusal(with([](auto& p) { p.name = "Upper"; }), tree.root()), "R2W0205");
  EXPECT_EQ(refusal(with([](auto& p) { p.version = "1-2"; }), tree.root()), "R2W0205");
  EXPECT_EQ(refusal(with([](auto& p) { p.version = "1..2"; }), tree.root()), "R2W0205");
  EXPECT_EQ(refusal(with([](auto& p) { p.build = ""; }), tree.root()), "R2W0205");
  EXPECT_EQ(refusal(with([](auto& p) { p.depends = {"a >="}; }), tree.root()), "R2W0205");
  EXPECT_EQ(refusal(with([](auto& p) { p.subdir = "emscripten-wasm32"; }), tree.root()), "R2W0205");
  EXPECT_EQ(refusal(package(), tree / "absent"), "R2W0210");
  EXPECT_EQ(refusal(with([](auto& p) { p.entry_points = {"a = b:c"}; }), tree.root()), "R2W0205");
  for (const char* bad : {"", "a", "a = b", "= b:c", "../a = b:c", "a/b = b:c", ".a = b:c",
                          "-a = b:c", "a = b.:c", "a = b:", "a = 1b:c", "a = b;x:c", "a = b:c()"}) {
    EXPECT_EQ(refusal(with([&](auto& p) {
                        p.noarch = NoarchKind::kPython;
                        p.entry_points = {bad};
                      }),
                      tree.root()),
              "R2W0205")
        << bad;
  }
}

TEST(CondaWriter, RefusesWhatCannotBePacked) {
  const testing::TemporaryTree tree;
  fs::create_directories(tree / "p");
  fs::create_symlink("../../outside", tree / "p/link");
  EXPECT_EQ(refusal(package(), tree / "p"), "R2W0206");
  fs::remove(tree / "p/link");
  tree.write("p/info/index.json", "{}");
  EXPECT_EQ(refusal(package(), tree / "p"), "R2W0206");
}

TEST(ZipWriter, Crc32) {
  EXPECT_EQ(crc32("123456789"), 0xCBF43926U);
}

}  // namespace
}  // namespace ros2wasm
