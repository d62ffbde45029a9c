#include "bundler/build/movable_tree.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

class MovableTreeTest : public ::testing::Test {
 protected:
  void SetUp() override {
    auto made = TemporaryDirectory::make("movable-");
    ASSERT_TRUE(made);
    root_.emplace(std::move(*made));
    prefix_ = root_->path() / "built" / "arm-0123";
    other_ = root_->path() / "built" / "base-4567";
    write("share/arm/package.xml", "<package/>");
  }

  void write(const std::string& path, const std::string& text) const {
    ASSERT_TRUE(write_file(prefix_ / path, text));
  }

  [[nodiscard]] Outcome<MovableTree> make() const {
    return make_movable(prefix_, "arm",
                        {.prefixes = {prefix_, other_}, .others = {root_->path() / "src"}}, to());
  }

  [[nodiscard]] fs::path to() const { return root_->path() / "copy"; }

  [[nodiscard]] std::string read(const std::string& path) const {
    const auto text = read_file(to() / path, kMostOfText);
    return text ? *text : "<absent>";
  }

  std::optional<TemporaryDirectory> root_;
  fs::path prefix_;
  fs::path other_;
};

TEST_F(MovableTreeTest, TextsNameThePlaceOfInstallation) {
  write("share/arm/cmake/armConfig.cmake",
        "set(a " + prefix_.string() + "/include)\nset(b " + other_.string() + "/lib)\n");
  const auto tree = make();
  ASSERT_TRUE(tree);
  const std::string place = kMovablePrefix;
  EXPECT_EQ(read("share/arm/cmake/armConfig.cmake"),
            "set(a " + place + "/include)\nset(b " + place + "/lib)\n");
  EXPECT_TRUE(tree->fixed.empty());
  EXPECT_FALSE(tree->is_compiled);
}

TEST_F(MovableTreeTest, CompiledFilesThatNameThisMachineAreListed) {
  const std::string program = std::string("\0asm", 4) + prefix_.string() + "/share";
  write("lib/arm/driver.wasm", program);
  const auto tree = make();
  ASSERT_TRUE(tree);
  EXPECT_EQ(tree->fixed, std::vector<std::string>{"lib/arm/driver.wasm"});
  EXPECT_TRUE(tree->is_compiled);
  EXPECT_EQ(read("lib/arm/driver.wasm"), program);
}

TEST_F(MovableTreeTest, FoldersOfSourcesAreNamedInTextsToo) {
  write("share/arm/map.yaml", "image: " + (root_->path() / "src/arm/map.pgm").string() + "\n");
  const auto tree = make();
  ASSERT_TRUE(tree);
  EXPECT_EQ(tree->fixed, std::vector<std::string>{"share/arm/map.yaml"});
}

TEST_F(MovableTreeTest, APlaceBehindALinkIsKnownInBothSpellings) {
  std::error_code error;
  fs::create_directory_symlink(root_->path() / "built", root_->path() / "by_link", error);
  ASSERT_FALSE(error);
  write("share/arm/a.cmake", prefix_.string() + "\n");
  const auto tree = make_movable(
      prefix_, "arm", {.prefixes = {root_->path() / "by_link" / "arm-0123"}, .others = {}}, to());
  ASSERT_TRUE(tree);
  EXPECT_EQ(read("share/arm/a.cmake"), std::string(kMovablePrefix) + "\n");
}

TEST_F(MovableTreeTest, ScriptsForShellsAndNotesOfTheBuildAreSkipped) {
  for (const char* path :
       {".ros2wasm-complete", "lib/arm/driver.left_out", "share/arm/local_setup.sh",
        "share/arm/package.dsv", "share/ament_index/resource_index/parent_prefix_path/arm"})
    write(path, "x");
  write("share/arm/config/package.dsv", "kept");
  write("share/arm/environment/models.dsv",
        "prepend-non-duplicate;GAZEBO_MODEL_PATH;share/arm/models");
  ASSERT_TRUE(make());
  const auto files = list_tree(to());
  ASSERT_TRUE(files);
  std::vector<std::string> paths;
  for (const TreeEntry& one : *files) paths.push_back(one.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"share/arm/config/package.dsv",
                                             "share/arm/environment/models.dsv",
                                             "share/arm/package.xml"}));
}

TEST_F(MovableTreeTest, KitsNameFilesByTheirPlace) {
  const std::string kit = "link_kits/arm/plugins/base/arm__lib/";
  write("lib/libarm.a", "!<arch>\n");
  write(kit + "3/libarm.a", "!<arch>\n");
  write(kit + "2/own.o", "object");
  write(kit + "arguments",
        "-O1\nkit:2/own.o\nkit:3/libarm.a\n" + other_.string() + "/lib/libbase.a\n");
  ASSERT_TRUE(make());
  EXPECT_EQ(read(kit + "arguments"),
            "-O1\nkit:2/own.o\nprefix:lib/libarm.a\nprefix:lib/libbase.a\n");
  EXPECT_EQ(read(kit + "2/own.o"), "object");
  EXPECT_EQ(read(kit + "3/libarm.a"), "<absent>");
}

TEST_F(MovableTreeTest, AKitWithAFileOfThisMachineIsAnError) {
  write("link_kits/arm/plugins/base/arm__lib/arguments", "/usr/lib/libm.a\n");
  const auto tree = make();
  ASSERT_FALSE(tree);
  EXPECT_EQ(tree.errors().front().code, "R2W0505");
}

TEST_F(MovableTreeTest, TheHashIsThatOfTheCopy) {
  const auto first = make();
  ASSERT_TRUE(first);
  ASSERT_TRUE(remove_tree(to()));
  write("share/arm/local_setup.sh", "skipped");
  EXPECT_EQ(make()->hash, first->hash);
  ASSERT_TRUE(remove_tree(to()));
  write("share/arm/more", "x");
  EXPECT_NE(make()->hash, first->hash);
}

}  // namespace
}  // namespace ros2wasm
