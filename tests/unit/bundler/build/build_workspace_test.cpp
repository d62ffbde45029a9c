// Tests of the messages about the build folder, the order of builds, the number of compilers, and
// skipped packages. The tests of pack do real builds: here `cmake` and `ninja` only record their
// calls.
#include "bundler/build/build_workspace.hpp"
#include "bundler/languages/language.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

class WorkspaceBuildTest : public ::testing::Test {
 protected:
  WorkspaceBuildTest() {
    script(
        "cmake",
        "while [ $# -gt 1 ]; do [ \"$1\" = -B ] && : >\"$2/build.ninja\"; shift; done\nexit 0\n");
    // $2 is the folder of the build, $6 the number of jobs.
    script("ninja", "name=$(basename \"$2\"); echo \"${name%-*} -j$6\" >>" +
                        (tree_ / "log").string() + "\n. " + tree_.write("tools/more", "").string() +
                        "\n");
    const char* path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe)
    const std::string with_ours = (tree_ / "tools").string() + ":" + (path == nullptr ? "" : path);
    ::setenv("PATH", with_ours.c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
  }

  void script(const std::string& name, const std::string& text) const {
    tree_.write("tools/" + name, "#!/bin/sh\n" + text);
    fs::permissions(tree_ / ("tools/" + name), fs::perms::owner_all);
  }

  /// Sets the commands that every `ninja` runs besides recording its call.
  void every_ninja(const std::string& text) const { tree_.write("tools/more", text); }

  [[nodiscard]] std::string until_both_run() const {
    return "tries=0\nuntil [ \"$(wc -l <" + (tree_ / "log").string() +
           ")\" -ge 2 ]; do\n"
           "  tries=$((tries + 1)); [ $tries -lt 3000 ] || exit 1; sleep 0.01\ndone\n";
  }

  void package(const std::string& name, const std::string& needs,
               const std::string& build_type = "ament_cmake") const {
    const std::string depend = needs.empty() ? "" : "<depend>" + needs + "</depend>";
    tree_.write("src/" + name + "/package.xml",
                "<package format=\"3\">\n<name>" + name + "</name>\n<version>1.0.0</version>\n" +
                    "<description>d</description>\n<maintainer email=\"a@b.c\">m</maintainer>\n" +
                    "<license>MIT</license>\n" + depend + "<export><build_type>" + build_type +
                    "</build_type></export>\n</package>\n");
  }

  [[nodiscard]] Outcome<WorkspaceBuild> build(unsigned jobs) const {
    auto packages = discover_packages(tree_.root(), "", {{.value = "src", .span = {}}},
                                      ros_condition_variables("jazzy"));
    if (!packages) return std::move(packages).errors();
    const auto order = order_packages(*packages, "jazzy");
    if (!order) return order.errors();
    tree_.write("toolchain/toolchain.cmake", "");
    tree_.write("c_messages/c_headers.py", "");
    const BuildTools tools{.compiler = {},
                           .compiler_environment = {},
                           .toolchain = tree_ / "toolchain/toolchain.cmake",
                           .c_messages = tree_ / "c_messages",
                           .cli = "ros2wasm",
                           .jobs = jobs};
    const auto left_out = left_out_packages(*packages, *order, {.names = {}, .of_lock = true},
                                            "jazzy", known_build_types());
    return build_workspace(*packages, *order, left_out, tools,
                           {.cache = tree_ / "cache", .builder_of = builder_of}, {}, {});
  }

  [[nodiscard]] static std::string names(const WorkspaceBuild& build) {
    std::string text;
    for (const BuiltPackage& one : build.packages)
      text += one.name + (one.from_cache ? " as before" : "") + ", ";
    return text;
  }

  testing::TemporaryTree tree_;
};

TEST_F(WorkspaceBuildTest, WhatIsNeededComesFirstWithAllJobs) {
  package("a", "b");
  package("b", "c");
  package("c", "");
  const auto built = build(4);
  ASSERT_TRUE(built);
  EXPECT_EQ(names(*built), "c, b, a, ");
  EXPECT_EQ(tree_.read("log"), "c -j4\nb -j4\na -j4\n");
  EXPECT_EQ(names(*build(4)), "c as before, b as before, a as before, ");
  package("b", "");
  EXPECT_EQ(names(*build(4)), "b, a, c as before, ");
}

TEST_F(WorkspaceBuildTest, PackagesAtOnceShareTheJobs) {
  package("a", "");
  package("b", "");
  every_ninja(until_both_run());
  const auto built = build(4);
  ASSERT_TRUE(built);
  const std::string log = tree_.read("log");
  EXPECT_NE(log.find("a -j2\n"), std::string::npos) << log;
  EXPECT_NE(log.find("b -j2\n"), std::string::npos) << log;
}

TEST_F(WorkspaceBuildTest, TheBiggerOneGetsMoreJobs) {
  package("a", "");
  package("b", "");
  for (const char* source : {"1.cpp", "2.cpp", "3.c", "4.msg", "5.cc"})
    tree_.write(std::string("src/b/src/") + source, "");
  every_ninja(until_both_run());
  const auto built = build(8);
  ASSERT_TRUE(built);
  const std::string log = tree_.read("log");
  EXPECT_NE(log.find("a -j1\n"), std::string::npos) << log;
  EXPECT_NE(log.find("b -j7\n"), std::string::npos) << log;
}

TEST_F(WorkspaceBuildTest, ABigOneTakesAllOfFewJobsAndComesFirst) {
  package("a", "");
  package("b", "");
  for (const char* source : {"1.cpp", "2.cpp", "3.c", "4.msg", "5.cc"})
    tree_.write(std::string("src/b/src/") + source, "");
  ASSERT_TRUE(build(2));
  EXPECT_EQ(tree_.read("log"), "b -j2\na -j2\n");
}

TEST_F(WorkspaceBuildTest, WhatNeedsALeftOutPackageIsLeftOutToo) {
  package("good", "");
  package("listener", "talker");
  package("py", "", "ament_cargo");
  package("talker", "py");
  const auto built = build(2);
  ASSERT_TRUE(built);
  EXPECT_EQ(names(*built), "good, ");
  ASSERT_EQ(built->warnings.size(), 3U);
  for (const Diagnostic& warning : built->warnings) EXPECT_EQ(warning.code, "R2W0514");
  EXPECT_EQ(built->warnings[0].message,
            "package `listener` is skipped: it needs `talker`, which is skipped");
  EXPECT_EQ(built->left_out.at("listener"),
            (std::vector<std::string>{"it needs `talker`, which is skipped",
                                      "`talker` is skipped: it needs `py`, which is skipped",
                                      "`py` is skipped: packages of build type `ament_cargo` are "
                                      "not built for sites (src/py/package.xml:2)"}));
  EXPECT_EQ(built->warnings[2].message,
            "package `talker` is skipped: it needs `py`, which is skipped");
}

TEST_F(WorkspaceBuildTest, APythonPackageNeedsSetupPyAndPyodide) {
  package("py", "", "ament_python");
  const auto without_setup = build(1);
  ASSERT_FALSE(without_setup);
  EXPECT_EQ(without_setup.errors()[0].code, "R2W0516");
  tree_.write("src/py/setup.py", "");
  const auto without_pyodide = build(1);
  ASSERT_FALSE(without_pyodide);
  EXPECT_EQ(without_pyodide.errors()[0].code, "R2W0517");
  EXPECT_EQ(without_pyodide.errors()[0].kind, FailureKind::kEnvironment);
}

TEST_F(WorkspaceBuildTest, AFailureStopsOnlyWhatNeedsIt) {
  package("bad", "");
  package("good", "");
  package("talker", "bad");
  every_ninja("case $name in bad-*) exit 1;; esac\n");
  const auto built = build(2);
  ASSERT_FALSE(built);
  ASSERT_EQ(built.errors().size(), 1U);
  EXPECT_EQ(built.errors()[0].code, "R2W0506");
  const std::string log = tree_.read("log");
  EXPECT_NE(log.find("good "), std::string::npos);
  EXPECT_EQ(log.find("talker "), std::string::npos);
}

TEST(LittleRoom, IsSaidOnlyWhenItCanBeTheReason) {
  EXPECT_FALSE(little_room("/cache", 64'000'000));
  const auto full = little_room("/cache", 4'200'000);
  ASSERT_TRUE(full);
  EXPECT_EQ(full->code, "R2W0640");
  EXPECT_EQ(full->kind, FailureKind::kEnvironment);
  EXPECT_EQ(full->message, "the disk has too little room to build: 4 MB are left");
  EXPECT_EQ(full->why.front(), "packages are built in /cache");
}

}  // namespace
}  // namespace ros2wasm
