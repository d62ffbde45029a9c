#include "bundler/build/setup_plan.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

const BuildPlace kPlace{.package = "demo",
                        .source = "/w/src/demo",
                        .display = "src/demo",
                        .compiler_version = {},
                        .channel_packages = {}};

TEST(SetupPlan, HasFilesProgramsAndEntryPoints) {
  const auto plan = read_setup_plan(
      R"({"name": "demo", "version": "1.2", "script_folder": "lib/demo",
          "modules": [["src/demo/a.py", "demo/a.py"]], "data": [["package.xml", "share/demo/package.xml"]],
          "scripts": [["tools/run", "lib/demo/run"]],
          "entry_points": {"console_scripts": ["talk = demo.a:Talker.main [extra]"], "demo.plugins": ["x = demo.x"]}})",
      kPlace);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->name, "demo");
  ASSERT_EQ(plan->modules.size(), 1U);
  EXPECT_EQ(plan->modules[0].from, "src/demo/a.py");
  EXPECT_EQ(plan->modules[0].to, "demo/a.py");
  ASSERT_EQ(plan->scripts.size(), 1U);
  ASSERT_EQ(plan->programs.size(), 1U);
  EXPECT_EQ(entry_point_script(plan->programs[0], "demo"),
            "#!/usr/bin/env python3\n# The entry point `talk = demo.a:Talker.main` of demo.\n"
            "import sys\n\nfrom demo.a import Talker\n\nsys.exit(Talker.main())\n");
  EXPECT_EQ(entry_points_text(*plan),
            "[console_scripts]\ntalk = demo.a:Talker.main [extra]\n\n[demo.plugins]\nx = demo.x\n");
}

TEST(SetupPlan, HasWhatSetupPyItselfInstalls) {
  const auto plan = read_setup_plan(
      R"({"name": "demo", "version": "1.2", "script_folder": "bin",
          "written": [["lib/python3.12/site-packages/demo/made.py", "x = 1\n"]]})",
      kPlace);
  ASSERT_TRUE(plan);
  ASSERT_EQ(plan->written.size(), 1U);
  EXPECT_EQ(plan->written[0].to, "lib/python3.12/site-packages/demo/made.py");
  EXPECT_EQ(plan->written[0].text, "x = 1\n");
  const auto out = read_setup_plan(
      R"({"name": "demo", "version": "1.2", "script_folder": "bin", "written": [["../x", ""]]})",
      kPlace);
  ASSERT_FALSE(out);
  EXPECT_EQ(out.errors().front().why.front(), "`../x` leads out of its folder");
}

TEST(SetupPlan, NamesKeywordsThatSetupDoesNotHave) {
  const auto plan = read_setup_plan(
      R"({"name": "demo", "version": "1.2", "script_folder": "bin",
          "unknown": [{"keyword": "entry_pints", "line": 9}, {"keyword": "colour", "line": 0}]})",
      kPlace);
  ASSERT_TRUE(plan);
  ASSERT_EQ(plan->warnings.size(), 2U);
  EXPECT_EQ(plan->warnings[0].code, "R2W0527");
  EXPECT_EQ(plan->warnings[0].message, "setup() of package `demo` has no keyword `entry_pints`");
  EXPECT_EQ(plan->warnings[0].span->line, 9U);
  EXPECT_EQ(plan->warnings[0].fix, std::vector<std::string>{"write `entry_points=`"});
  EXPECT_TRUE(plan->warnings[1].fix.empty());
}

TEST(SetupPlan, NamesLinesThatAreSkipped) {
  const auto plan = read_setup_plan(
      R"({"name": "demo", "version": "1.2", "script_folder": "bin",
          "warnings": [{"file": "MANIFEST.in", "line": 3, "message": "`graft` expects one folder"}]})",
      kPlace);
  ASSERT_TRUE(plan);
  ASSERT_EQ(plan->warnings.size(), 1U);
  EXPECT_EQ(plan->warnings[0].code, "R2W0527");
  EXPECT_EQ(plan->warnings[0].severity, Severity::kWarning);
  EXPECT_EQ(plan->warnings[0].message, "a line of MANIFEST.in of package `demo` is skipped");
  EXPECT_EQ(plan->warnings[0].span->line, 3U);
  EXPECT_EQ(plan->warnings[0].why.front(), "`graft` expects one folder");
}

TEST(SetupPlan, TellsWhereSetupFailed) {
  const auto plan = read_setup_plan(
      R"({"error": {"file": "setup.py", "line": 7, "message": "NameError: name 'x' is not defined"}})",
      kPlace);
  ASSERT_FALSE(plan);
  const Diagnostic& error = plan.errors().front();
  EXPECT_EQ(error.code, "R2W0516");
  ASSERT_TRUE(error.span);
  EXPECT_EQ(error.span->file, "src/demo/setup.py");
  EXPECT_EQ(error.span->line, 7U);
  EXPECT_EQ(error.why.front(), "NameError: name 'x' is not defined");
}

TEST(SetupPlan, RefusesWhatLeavesItsFolderOrIsNoEntryPoint) {
  const auto refused = [](const std::string& part) {
    const auto plan =
        read_setup_plan(R"({"name": "demo", "script_folder": "lib/demo", )" + part + "}", kPlace);
    return plan ? std::string() : plan.errors().front().why.front();
  };
  EXPECT_EQ(refused(R"("data": [["a", "../x"]])"), "`../x` leads out of its folder");
  EXPECT_EQ(refused(R"("modules": [["/etc/passwd", "x"]])"),
            "`/etc/passwd` leads out of its folder");
  for (const char* line : {"talk", "talk = demo:", "talk = demo main", "../talk = demo:main",
                           "talk = demo:main()", " = a:b"}) {
    EXPECT_EQ(refused(R"("entry_points": {"console_scripts": [")" + std::string(line) + R"("]})"),
              "the entry point `" + std::string(line) +
                  "` is not `NAME = MODULE:FUNCTION` or `NAME = MODULE`");
  }
  EXPECT_EQ(refused(R"("data": [["a", "share/demo/a"]])"), "");
}

TEST(SetupPlan, AnEntryPointWithoutFunctionFailsWhenItRuns) {
  const auto plan = read_setup_plan(
      R"({"name": "demo", "version": "1", "script_folder": "lib/demo",
          "entry_points": {"console_scripts": ["talk = demo.talk", "hear = demo.hear:main"]}})",
      kPlace);
  ASSERT_TRUE(plan);
  ASSERT_EQ(plan->programs.size(), 2U);
  EXPECT_EQ(plan->programs[0].function, "");
  const std::string script = entry_point_script(plan->programs[0], "demo");
  EXPECT_NE(script.find("\nimport demo.talk\n\nsys.exit(demo.talk())\n"), std::string::npos);
  EXPECT_EQ(plan->programs[1].function, "main");
}

TEST(SetupPlan, RefusesNamesAndVersionsThatAreNoPartOfAFolderName) {
  const auto refused = [](const std::string& name, const std::string& version) {
    const auto plan = read_setup_plan(R"({"script_folder": "lib/demo", "name": ")" + name +
                                          R"(", "version": ")" + version + R"("})",
                                      kPlace);
    return plan ? std::string() : plan.errors().front().why.front();
  };
  EXPECT_EQ(refused("demo-nodes_2", "1!2.0.0-rc.1+local"), "");
  EXPECT_EQ(refused("../../evil", "1.0"),
            "the name `../../evil` has other characters than letters, digits and `._+!-`");
  for (const char* version : {"1/../../../evil", "attr: demo.__version__", "1 2", "1\\n2"}) {
    EXPECT_TRUE(refused("demo", version).starts_with("the version `")) << version;
  }
}

}  // namespace
}  // namespace ros2wasm
