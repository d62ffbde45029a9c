// Kits of links: what is kept, what of an earlier build is not, and how programs get their plugins.
#include "bundler/build/link_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "bundler/build/plugin_link.hpp"
#include "tests/unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {
namespace fs = std::filesystem;

/// Stands in the folder of a build, as the driver of links does.
class LinkKitTest : public ::testing::Test {
 protected:
  LinkKitTest() { fs::current_path(tree_.root()); }
  ~LinkKitTest() override { fs::current_path(before_); }

  [[nodiscard]] Outcome<Done> keep(const std::string& output,
                                   const std::vector<std::string>& arguments) const {
    return keep_link_kit(tree_ / "kits",
                         LinkLine{.output = output, .arguments = arguments, .thread_support = {}});
  }

  /// An installation of all kits, for the index entries `bases`.
  [[nodiscard]] fs::path installed(const std::string& name,
                                   const std::vector<std::string>& bases) const {
    const fs::path prefix = tree_ / name;
    tree_.write(name + "/lib/demo/run.wasm", "");
    for (const std::string& base : bases)
      tree_.write(name + "/share/ament_index/resource_index/" + base + "__pluginlib__plugin/demo",
                  "");
    EXPECT_TRUE(install_link_kits(tree_ / "kits", prefix, "demo").ok());
    return prefix;
  }

  testing::TemporaryTree tree_;

 private:
  fs::path before_ = fs::current_path();
};

TEST_F(LinkKitTest, AProgramThatLoadsPluginsHasCopiesOfWhatWasBuilt) {
  tree_.write("run.o", "object");
  ASSERT_TRUE(keep("run.js", {"run.o", "/elsewhere/libpluginlib.a", "-O2"}).ok());
  fs::remove(tree_ / "run.o");
  const auto kits = program_kits(installed("one", {}), "demo");
  ASSERT_TRUE(kits);
  ASSERT_EQ(kits->size(), 1U);
  EXPECT_EQ(kits->front().name, "run");
  ASSERT_EQ(kits->front().arguments.size(), 3U);
  EXPECT_EQ(tree_.read(fs::path(kits->front().arguments[0]).lexically_relative(tree_.root())),
            "object");
  EXPECT_EQ(kits->front().arguments[1], "/elsewhere/libpluginlib.a");
  EXPECT_EQ(kits->front().arguments[2], "-O2");
}

TEST_F(LinkKitTest, AProgramThatLoadsPluginsNoMoreHasNoKit) {
  tree_.write("run.o", "object");
  ASSERT_TRUE(keep("run.js", {"run.o", "/elsewhere/libpluginlib.a"}).ok());
  ASSERT_TRUE(keep("run.js", {"run.o"}).ok());
  EXPECT_TRUE(program_kits(installed("one", {}), "demo")->empty());
}

TEST_F(LinkKitTest, AContainerOfComponentsHasAKitAndLoadsNoPlugins) {
  tree_.write("part.a", "components");
  tree_.write("whole/lib/demo/component_container_mt.wasm", "");
  ASSERT_TRUE(keep("component_container_mt.wasm", {"part.a"}).ok());
  const auto kits = program_kits(installed("whole", {}), "demo");
  ASSERT_TRUE(kits);
  ASSERT_EQ(kits->size(), 1U);
  EXPECT_EQ(kits->front().name, "component_container_mt");
  EXPECT_FALSE(loads_plugins(kits->front().arguments));
}

TEST_F(LinkKitTest, OnlyPluginsThatTheLastConfigureNamedAreInstalled) {
  tree_.write("a.a", "plugins");
  for (const char* name : {"shapes__a__plugins", "shapes__b__plugins"})
    ASSERT_TRUE(keep(std::string(name) + ".js", {"--ros2wasm-plugins-of=shapes", "a.a"}).ok());
  ASSERT_TRUE(keep("tools__a__plugins.js", {"--ros2wasm-plugins-of=tools", "a.a"}).ok());
  tree_.write("kits/plugins/shapes/named", "shapes__a__plugins\nshapes__b__plugins\n");
  tree_.write("kits/plugins/tools/named", "tools__a__plugins\n");
  EXPECT_EQ(plugin_kits(installed("one", {"shapes"}), "demo")->size(), 2U);
  tree_.write("kits/plugins/shapes/named", "shapes__b__plugins\n");
  const auto kits = plugin_kits(installed("two", {"shapes", "tools"}), "demo");
  ASSERT_TRUE(kits);
  ASSERT_EQ(kits->size(), 2U);
  EXPECT_EQ((*kits)[0].name, "shapes__b__plugins");
  EXPECT_EQ((*kits)[0].base, "shapes");
  EXPECT_EQ((*kits)[1].base, "tools");
  EXPECT_EQ((*kits)[1].arguments.size(), 1U);
}

/// A package of a channel: built beside others in one prefix, installed into a tree, used
/// elsewhere.
TEST_F(LinkKitTest, KitsOfAChannelNameFilesByTheirPlaceInAPrefix) {
  tree_.write("run.o", "object");
  tree_.write("libcore.a", "core");
  const std::string pluginlib = (tree_ / "others/lib/libpluginlib.a").string();
  ASSERT_TRUE(keep("run.js", {"run.o", "libcore.a", pluginlib, "-O2"}).ok());
  tree_.write("component_container.o", "object");
  ASSERT_TRUE(keep("component_container.js", {"component_container.o"}).ok());
  tree_.write("tree/lib/demo/run.wasm", "");
  tree_.write("tree/lib/demo/component_container.wasm", "");
  tree_.write("tree/lib/libcore.a", "core");
  ASSERT_TRUE(install_movable_kits(tree_ / "kits", tree_ / "tree", "demo", tree_ / "others").ok());
  fs::rename(tree_ / "tree", tree_ / "elsewhere");
  EXPECT_EQ(packages_with_kits(tree_ / "elsewhere"), std::vector<std::string>{"demo"});
  const auto kits = program_kits(tree_ / "elsewhere", "demo");
  ASSERT_TRUE(kits);
  ASSERT_EQ(kits->size(), 1U);  // not the container
  EXPECT_EQ(
      kits->front().arguments,
      (std::vector<std::string>{(tree_ / "elsewhere/link_kits/demo/programs/run/0/run.o").string(),
                                (tree_ / "elsewhere/lib/libcore.a").string(),
                                (tree_ / "elsewhere/lib/libpluginlib.a").string(), "-O2"}));
}

TEST_F(LinkKitTest, AProgramOfAChannelThatNeedsWhatNoPackageHasIsRefused) {
  tree_.write("run.o", "object");
  ASSERT_TRUE(keep("run.js", {"run.o", "/elsewhere/libpluginlib.a"}).ok());
  tree_.write("tree/lib/demo/run.wasm", "");
  const auto done = install_movable_kits(tree_ / "kits", tree_ / "tree", "demo", tree_ / "others");
  ASSERT_FALSE(done.ok());
  EXPECT_EQ(done.errors().front().code, "R2W0505");
  EXPECT_EQ(done.errors().front().why.front(),
            "it is linked with /elsewhere/libpluginlib.a, which is in no package");
}

TEST_F(LinkKitTest, AKitThatNamesFilesElsewhereIsRefused) {
  for (const char* line :
       {"prefix:../secret.a", "kit:/etc/secret.a", "prefix:lib/../../secret.a"}) {
    tree_.write("hostile/link_kits/demo/programs/run/arguments", std::string(line) + "\n");
    const auto kits = program_kits(tree_ / "hostile", "demo");
    ASSERT_FALSE(kits) << line;
    EXPECT_EQ(kits.errors().front().code, "R2W0505");
  }
}

constexpr const char* kWhole = "-Wl,--whole-archive";
constexpr const char* kNotWhole = "-Wl,--no-whole-archive";

class PluginArgumentsTest : public LinkKitTest {
 protected:
  [[nodiscard]] BuiltPackage package(const std::string& name) const {
    return {.name = name, .version = {}, .prefix = tree_ / name, .hash = {}};
  }
  [[nodiscard]] std::string in(const std::string& path) const { return (tree_ / path).string(); }
};

TEST_F(PluginArgumentsTest, LibrariesOfOneNameInTwoPackagesAreTwo) {
  const std::vector<BuiltPackage> built = {package("left"), package("right"), package("app")};
  const PluginLibrary left{
      .kit = {.name = "k", .base = "shapes", .arguments = {in("left/kit/0/libplugins.a"), "-lm"}},
      .package = &built[0]};
  const PluginLibrary right{.kit = {.name = "k",
                                    .base = "shapes",
                                    .arguments = {in("right/kit/0/libplugins.a"), "none.o"}},
                            .package = &built[1]};
  const LinkKit program{.name = "run", .base = {}, .arguments = {"run.o"}};
  EXPECT_EQ(arguments_with_plugins(program, {&left, &right}, built),
            (std::vector<std::string>{kWhole, in("left/kit/0/libplugins.a"), kNotWhole, kWhole,
                                      in("right/kit/0/libplugins.a"), kNotWhole, "run.o",
                                      in("left/kit/0/libplugins.a"), "-lm",
                                      in("right/kit/0/libplugins.a")}));
}

TEST_F(PluginArgumentsTest, WhatIsWholeAlreadyIsNotGivenAgain) {
  const std::vector<BuiltPackage> built = {package("left"), package("app")};
  const PluginLibrary first{
      .kit = {.name = "k", .base = "shapes", .arguments = {in("left/kits/a/0/libplugins.a")}},
      .package = &built[0]};
  const PluginLibrary second{
      .kit = {.name = "k", .base = "tools", .arguments = {in("left/kits/b/0/libplugins.a")}},
      .package = &built[0]};
  const auto times_whole = [&](const LinkKit& program) {
    const auto found = arguments_with_plugins(program, {&first, &second}, built);
    return std::count(found.begin(), found.end(), kWhole);
  };
  EXPECT_EQ(times_whole({.name = "run", .base = {}, .arguments = {"run.o"}}), 1);
  const LinkKit itself{
      .name = "run", .base = {}, .arguments = {kWhole, in("left/lib/libplugins.a"), kNotWhole}};
  EXPECT_EQ(times_whole(itself), 1);
  const LinkKit another{
      .name = "run", .base = {}, .arguments = {kWhole, in("app/lib/libplugins.a"), kNotWhole}};
  EXPECT_EQ(times_whole(another), 2);
}

}  // namespace
}  // namespace ros2wasm
