// Warnings of the compiler as diagnostics, and how they outlive the command that gave them.
#include "bundler/build/compiler_warnings.hpp"

#include <gtest/gtest.h>

#include "tests/unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

const BuildPlace kPlace{.package = "demo",
                        .source = "/ws/src/demo",
                        .display = "src/demo",
                        .compiler_version = "3.1.6",
                        .channel_packages = {}};

const std::string kUnused =
    "In file included from /ws/src/demo/src/a.cpp:1:\n"
    "/ws/src/demo/src/part.hpp:2:9: warning: unused variable 'x' [-Wunused-variable]\n"
    "  { int x; }\n"
    "        ^\n";
const std::string kShadow =
    "/ws/src/demo/src/a.cpp:7:7: warning: declaration shadows a local variable [-Wshadow]\n"
    "  int twice;\n"
    "      ^\n"
    "/ws/src/demo/src/a.cpp:5:7: note: previous declaration is here\n"
    "  int twice;\n"
    "      ^\n"
    "2 warnings generated.\n";
TEST(CompilerWarnings, AreWholeAndOnlyThoseOfThePackage) {
  const Diagnostics found = compiler_warnings(
      kUnused + kShadow + "/opt/include/x.hpp:1:1: warning: of others [-Wother]\nint x;\n^\n",
      kPlace);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].code, kCompilerWarning);
  EXPECT_EQ(found[0].severity, Severity::kWarning);
  EXPECT_EQ(found[0].message, "unused variable 'x' [-Wunused-variable]");
  EXPECT_EQ(found[0].span->file, "src/part.hpp");
  EXPECT_EQ(found[0].span->line, 2U);
  EXPECT_EQ(found[0].span->line_text, "  { int x; }");
  EXPECT_EQ(found[0].detail, "");
  EXPECT_NE(found[1].detail.find("a.cpp:5:7: note: previous declaration is here\n"),
            std::string::npos);
  EXPECT_EQ(found[1].detail.find("generated"), std::string::npos);
}

std::string narrowing(const std::string& types) {
  return "/ws/src/demo/src/a.cpp:3:12: warning: implicit conversion loses integer precision: " +
         types + " [-Wshorten-64-to-32]\n  long l = f();\n           ^\n";
}

TEST(CompilerWarnings, TellOfNarrowingWhereLongIsWiderNatively) {
  const std::string wide = "'int64_t' (aka 'long long')";
  for (const char* target : {"'long'", "'unsigned long'", "'time_t' (aka 'long')", "'const long'",
                             "'duration::rep' (aka 'unsigned long')"}) {
    const Diagnostics found = compiler_warnings(narrowing(wide + " to " + target), kPlace);
    ASSERT_EQ(found.size(), 1U) << target;
    EXPECT_EQ(found[0].why.at(0), "`long` has 32 bits in a site, and 64 natively");
    EXPECT_EQ(found[0].fix.size(), 1U);
  }
  for (const char* target :
       {"'int'", "'int32_t' (aka 'int')", "'size_t' (aka 'unsigned long')", "'float'",
        "'std::vector<int>::size_type' (aka 'unsigned long')", "'ptrdiff_t' (aka 'long')"})
    EXPECT_TRUE(compiler_warnings(narrowing(wide + " to " + target), kPlace).empty()) << target;
}

TEST(CompilerWarnings, SayNothingOfTheHeaderThatChecksFormats) {
  const Diagnostics found = compiler_warnings(
      "/ws/src/demo/src/a.cpp:3:9: warning: the format has more or fewer conversions than there "
      "are arguments [-Wuser-defined-warnings]\n  printf(\"%d\", 1, 2);\n        ^\n"
      "/p/include/stdio.h:20:81: note: from 'diagnose_if' attribute on 'printf<int, int>':\n"
      "inline int printf(const char* format, A... arguments) ROS2WASM_LP64_CHECKED(format) {\n"
      "                                                      ^~~~\n"
      "/p/include/lp64_format.hpp:126:18: note: expanded from macro 'ROS2WASM_LP64_CHECKED'\n"
      "  diagnose_if(x)\n  ^\n",
      kPlace);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].detail, "");
}

TEST(CompilerWarnings, OutliveRunsThatDoNotCompileTheirFileAgain) {
  const auto run = [](const std::string& more) {
    return command_findings(
        "[1/2] Building CXX object a.cpp.o\n" + more + "[2/2] Linking CXX executable tool.wasm\n",
        kPlace);
  };
  const std::string ninja = "build a.cpp.o: CXX x\nbuild b.cpp.o: CXX y\n";
  const CommandFindings first = current_findings({}, run(kUnused), ninja);
  ASSERT_EQ(first.size(), 1U);
  // b.cpp is compiled, and reads the same header.
  const auto second = current_findings(
      first, command_findings("[1/1] Building CXX object b.cpp.o\n" + kUnused + kShadow, kPlace),
      ninja);
  EXPECT_EQ(second.size(), 2U);
  EXPECT_EQ(all_findings(second).size(), 2U);
  // a.cpp is mended, b.cpp is gone.
  EXPECT_TRUE(current_findings(second, run(""), "build a.cpp.o: CXX x\n").empty());
}

TEST(CompilerWarnings, AreKeptWithTheFolderAndThePackage) {
  const testing::TemporaryTree tree;
  const CommandFindings found = {{"a.o", compiler_warnings(kUnused + kShadow, kPlace)}};
  ASSERT_TRUE(write_command_findings(tree.root(), found));
  const CommandFindings read = read_command_findings(tree.root());
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read.at("a.o").at(1).detail, found.at("a.o").at(1).detail);
  ASSERT_TRUE(keep_findings(tree.root(), all_findings(read)));
  const Diagnostics kept = kept_findings(tree.root(), kPlace);
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(kept[0].span->file, "src/demo/src/part.hpp");
  EXPECT_EQ(kept[0].severity, Severity::kWarning);
  EXPECT_TRUE(kept_findings(tree / "elsewhere", kPlace).empty());
}

}  // namespace
}  // namespace ros2wasm
