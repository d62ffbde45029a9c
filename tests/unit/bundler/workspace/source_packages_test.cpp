// Which packages of sources a workspace takes.
#include "bundler/workspace/source_packages.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

class SourcePackagesTest : public ::testing::Test {
 protected:
  void package(const std::string& folder, const std::string& name,
               const std::vector<std::string>& needs = {}) const {
    std::string text = "<package format=\"3\">\n<name>" + name +
                       "</name>\n<version>1.0.0</version>\n<description>d</description>\n"
                       "<maintainer email=\"a@example.org\">A</maintainer>\n"
                       "<license>MIT</license>\n";
    for (const std::string& need : needs) text += "<depend>" + need + "</depend>\n";
    text +=
        "<test_depend>tested_with</test_depend>\n"
        "<export><build_type>ament_cmake</build_type></export>\n</package>\n";
    tree_.write(folder + "/package.xml", text);
  }

  SourceTree source(const std::string& folder,
                    const std::vector<std::string>& packages = {}) const {
    SourceTree made;
    made.entry.kind = SourceKind::kGit;
    made.entry.name = folder;
    made.entry.revision = "1.0";
    made.entry.packages = packages;
    for (std::size_t i = 0; i < packages.size(); ++i)
      made.entry.package_places.push_back(
          {.file = "workspace.yaml", .line = ++line_, .column = 5, .line_text = {}});
    made.locked = {.git = "https://example.org/" + folder + ".git",
                   .revision = "1.0",
                   .commit = std::string(40, 'c'),
                   .tree = std::string(40, 'd'),
                   .archive = {},
                   .sha256 = {}};
    made.folder = tree_ / folder;
    return made;
  }

  Outcome<SourcePackages> choose(const std::vector<SourceTree>& trees,
                                 const std::vector<LocalPackage>& workspace = {}) const {
    return choose_source_packages(trees, workspace, "shown", ros_condition_variables("jazzy"));
  }

  static std::string names(const Outcome<SourcePackages>& chosen) {
    std::string text;
    if (!chosen) {
      for (const Diagnostic& one : chosen.errors()) text += std::string(one.code) + " ";
      return text;
    }
    for (const LocalPackage& one : chosen->packages) text += one.xml.file + " ";
    return text;
  }

  testing::TemporaryTree tree_;
  mutable std::uint32_t line_ = 1;
};

TEST_F(SourcePackagesTest, NamedOnesComeWithWhatTheyNeed) {
  package("nav/server", "server", {"core", "msgs", "rclcpp"});
  package("nav/core", "core", {"msgs"});
  package("nav/other", "other");
  package("nav/tested_with", "tested_with");
  package("extra/msgs", "msgs");
  const auto chosen = choose({source("nav", {"server"}), source("extra", {"msgs"})});
  EXPECT_EQ(names(chosen), "nav/core/package.xml nav/server/package.xml extra/msgs/package.xml ");
  EXPECT_EQ(chosen->packages[0].origin, "git+https://example.org/nav.git@" + std::string(40, 'c'));
  EXPECT_EQ(chosen->packages[0].base, tree_ / "nav");
  EXPECT_EQ(chosen->remarks,
            (std::vector<std::string>{"from nav 1.0, commit cccccccccc: core, server",
                                      "from extra 1.0, commit cccccccccc: msgs"}));
  // A package that only a test needs is not taken; without a list all are.
  EXPECT_EQ(choose({source("nav")})->packages.size(), 4U);
}

TEST_F(SourcePackagesTest, NeedsComeFromTheSameSourceFirst) {
  package("a/arm", "arm", {"msgs"});
  package("b/msgs", "msgs");
  package("b/tool", "tool", {"msgs"});
  package("c/msgs", "msgs");
  EXPECT_EQ(names(choose({source("a", {"arm"}), source("c", {"msgs"}), source("b", {"tool"})})),
            "a/arm/package.xml c/msgs/package.xml b/tool/package.xml ");
  // A package that is asked for is not taken twice; all of two sources are all of both (R2W0511
  // follows).
  EXPECT_EQ(names(choose({source("b", {"tool"}), source("c")})),
            "b/tool/package.xml c/msgs/package.xml ");
  EXPECT_EQ(names(choose({source("b"), source("c")})),
            "b/msgs/package.xml b/tool/package.xml c/msgs/package.xml ");
}

TEST_F(SourcePackagesTest, TheWorkspaceGoesFirst) {
  package("src/core", "core", {"parts"});
  package("nav/server", "server", {"core"});
  package("nav/parts", "parts");
  package("nav/core", "core");
  const auto own = discover_packages(tree_ / "src", "src", {{.value = ".", .span = {}}},
                                     ros_condition_variables("jazzy"));
  ASSERT_TRUE(own.ok());
  const auto chosen = choose({source("nav", {"server"})}, *own);
  EXPECT_EQ(names(chosen), "nav/parts/package.xml nav/server/package.xml ");
  EXPECT_EQ(chosen->remarks.back(), "core is taken from the workspace, not from a source");
}

TEST_F(SourcePackagesTest, TwoPackagesOfOneNameInASourceAreBothThere) {
  package("nav/a/core", "core");
  package("nav/b/core", "core");
  EXPECT_EQ(names(choose({source("nav", {"core"})})),
            "nav/a/core/package.xml nav/b/core/package.xml ");  // order_packages(): R2W0511
}

TEST_F(SourcePackagesTest, ASourceThatASiteCarriedMayLackWhatTheWorkspaceHas) {
  package("src/core", "core");
  const auto own = discover_packages(tree_ / "src", "src", {{.value = ".", .span = {}}},
                                     ros_condition_variables("jazzy"));
  tree_.write("nav/SOURCE", "https://example.org/nav.git\n");
  SourceTree carried = source("nav", {"core"});
  carried.is_carried = true;
  EXPECT_EQ(names(choose({carried}, *own)), "");
  carried.entry.packages.clear();
  EXPECT_EQ(names(choose({carried}, *own)), "");
}

TEST_F(SourcePackagesTest, NamesThatNoSourceHasAreErrors) {
  package("nav/map_server", "nav2_map_server");
  const auto chosen = choose({source("nav", {"nav2_map_sever"})});
  ASSERT_EQ(names(chosen), "R2W0255 ");
  EXPECT_EQ(chosen.errors()[0].fix, std::vector<std::string>{"write `nav2_map_server`"});
  EXPECT_EQ(chosen.errors()[0].span->line, 2U);
  tree_.write("empty/README", "");
  EXPECT_EQ(names(choose({source("empty")})), "R2W0255 ");
}

TEST_F(SourcePackagesTest, ABrokenPackageMattersOnlyWhereItIsTaken) {
  package("nav/good", "good");
  tree_.write("nav/bad/package.xml", "<package>");
  EXPECT_EQ(names(choose({source("nav", {"good"})})), "nav/good/package.xml ");
  EXPECT_EQ(names(choose({source("nav")})).substr(0, 8), "R2W0120 ");
}

TEST_F(SourcePackagesTest, PointersOfGitLfsAreRefusedByName) {
  package("nav/good", "good");
  package("nav/meshes", "meshes");
  tree_.write("nav/meshes/arm.stl",
              "version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 12\n");
  EXPECT_EQ(names(choose({source("nav", {"good"})})), "nav/good/package.xml ");
  const auto chosen = choose({source("nav", {"meshes"})});
  ASSERT_EQ(names(chosen), "R2W0254 ");
  EXPECT_EQ(chosen.errors()[0].why[0], "Git LFS has: arm.stl");
}

TEST_F(SourcePackagesTest, AFolderOfTheUserIsNamedByItsPath) {
  package("drivers/arm", "arm");
  SourceTree tree = source("drivers");
  tree.can_change = true;
  tree.entry.kind = SourceKind::kFolder;
  tree.entry.place = "../drivers";
  tree.locked = {};
  const auto chosen = choose({tree});
  EXPECT_EQ(names(chosen), "drivers/arm/package.xml ");
  EXPECT_EQ(chosen->packages[0].origin, "");
}

}  // namespace
}  // namespace ros2wasm
