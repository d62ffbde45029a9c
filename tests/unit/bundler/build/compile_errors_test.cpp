// Output of ninja and cmake as diagnostics.
#include "bundler/build/compile_errors.hpp"

#include <gtest/gtest.h>

#include <chrono>

#include "bundler/build/diagnostic_json.hpp"
#include "bundler/build/missing_headers.hpp"
#include "bundler/build/older_cmake.hpp"
#include "tests/unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

const BuildPlace kPlace{.package = "demo",
                        .source = "/ws/src/demo",
                        .display = "src/demo",
                        .compiler_version = "3.1.6",
                        .channel_packages = {"nav_msgs", "std_msgs"}};

constexpr std::string_view kNinja =
    "[1/4] Building CXX object a.o\n"
    "FAILED: CMakeFiles/a.dir/src/a.cpp.o \n"
    "/usr/bin/em++ -c /ws/src/demo/src/a.cpp\n"
    "In file included from x:1:\n"
    "/ws/src/demo/src/a.cpp:4:13: error: use of undeclared identifier 'x'\n"
    "int main(){ x; }\n"
    "            ^\n"
    "1 error generated.\n"
    "em++: error: '/usr/bin/clang++-14 ...' failed (returned 1)\n"
    "[2/4] Building CXX object b.o\n"
    "FAILED: CMakeFiles/b.dir/src/b.cpp.o \n"
    "/usr/bin/em++ -c /ws/src/demo/src/b.cpp\n"
    "/usr/include/other.h:7:10: fatal error: 'expected' file not found\n"
    "ninja: build stopped: cannot make progress due to previous errors.\n";

TEST(CompileErrors, OnePerFileWithTheWholeMessage) {
  const Diagnostics errors = compile_errors(kNinja, kPlace);
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_EQ(errors[0].code, "R2W0502");
  EXPECT_EQ(errors[0].message, "package `demo` does not compile: use of undeclared identifier 'x'");
  ASSERT_TRUE(errors[0].span);
  EXPECT_EQ(errors[0].span->file, "src/demo/src/a.cpp");
  EXPECT_EQ(errors[0].span->line, 4U);
  EXPECT_EQ(errors[0].span->column, 13U);
  EXPECT_EQ(errors[0].span->line_text, "int main(){ x; }");
  EXPECT_NE(errors[0].detail.find("In file included from x:1:\n"), std::string::npos);
  EXPECT_NE(errors[0].detail.find("1 error generated.\n"), std::string::npos);
  EXPECT_EQ(errors[0].detail.find("em++: error"), std::string::npos);
  EXPECT_EQ(errors[1].span->file, "/usr/include/other.h");
}

TEST(CompileErrors, SaysWhatTheLibraryLacks) {
  const Diagnostics errors = compile_errors(kNinja, kPlace);
  ASSERT_EQ(errors[1].why.size(), 1U);
  EXPECT_EQ(errors[1].why[0],
            "the C++ library of Emscripten 3.1.6 has no <expected>; a newer Emscripten on PATH or "
            "in EMSDK may "
            "have it");
  EXPECT_TRUE(errors[0].why.empty());
}

TEST(CompileErrors, SaysWhoseHeaderTheTargetDoesNotAskFor) {
  const Diagnostics errors = compile_errors(
      "FAILED: CMakeFiles/a.dir/src/a.cpp.o \n"
      "/usr/bin/em++ -c /ws/src/demo/src/a.cpp\n"
      "/ws/src/demo/src/a.cpp:4:10: fatal error: 'std_msgs/msg/string.hpp' file not found\n"
      "FAILED: CMakeFiles/b.dir/src/b.cpp.o \n"
      "/usr/bin/em++ -c /ws/src/demo/src/b.cpp\n"
      "/ws/src/demo/src/b.cpp:4:10: fatal error: 'other_msgs/msg/string.hpp' file not found\n",
      kPlace);
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_EQ(errors[0].why, std::vector<std::string>{"package `std_msgs` has its headers, and the "
                                                    "target `a` does not name it"});
  EXPECT_EQ(errors[0].fix,
            std::vector<std::string>{"in CMakeLists.txt: `find_package(std_msgs REQUIRED)` and "
                                     "`ament_target_dependencies(a std_msgs)`; in package.xml: "
                                     "`<depend>std_msgs</depend>`"});
  EXPECT_TRUE(errors[1].why.empty());
}

TEST(CompileErrors, LinksSpeakForThemselvesAndOtherCommandsAreShown) {
  const Diagnostics errors = compile_errors(
      "FAILED: talker.wasm \n: && \"ros2wasm\" link-program --package demo -- em++ && :\nsome "
      "text\n"
      "FAILED: gen/x.hpp \npython3 gen.py\nTraceback\n",
      kPlace);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].code, "R2W0506");
  EXPECT_EQ(errors[0].message, "package `demo`: the command that makes `gen/x.hpp` failed");
  EXPECT_EQ(errors[0].detail, "Traceback\n");
}

TEST(CompileErrors, ALackOfMemoryIsSaid) {
  const auto failed = [](const std::string& text) {
    return compile_errors("FAILED: a.cpp.o \nem++ -c a.cpp\n" + text, kPlace).front();
  };
  const Diagnostic killed = failed("em++: error: 'clang++ ...' failed (received SIGKILL (-9))\n");
  EXPECT_EQ(killed.code, "R2W0521");
  EXPECT_EQ(killed.kind, FailureKind::kEnvironment);
  EXPECT_EQ(killed.message, "out of memory: package `demo` does not compile: a.cpp.o");
  EXPECT_EQ(failed("LLVM ERROR: out of memory\nStack dump:\n").code, "R2W0521");
  // A text about memory in a source does not mean that memory is missing.
  EXPECT_EQ(failed("/ws/a.cpp:4:1: error: no\nthrow \"Cannot allocate memory\";\n^\n").code,
            "R2W0502");
  const Diagnostics other =
      compile_errors("FAILED: gen/x.hpp \npython3 gen.py\nTraceback\nMemoryError\n", kPlace);
  EXPECT_EQ(other.front().code.text(), "R2W0521");
}

TEST(ConfigureErrors, ThePlaceIsTheFirstErrors) {
  const Diagnostics errors = configure_errors(
      "-- x\nCMake Error at CMakeLists.txt:8 (add_executable):\n  Cannot find source file:\n",
      kPlace);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].code, "R2W0503");
  EXPECT_EQ(errors[0].span->file, "src/demo/CMakeLists.txt");
  EXPECT_EQ(errors[0].span->line, 8U);
}

TEST(ConfigureErrors, TheMessageSaysTheFirstReason) {
  const auto said = [](std::string_view output) {
    return configure_errors(output, kPlace).front();
  };
  const std::string before = "CMakeLists.txt of package `demo` failed: ";
  EXPECT_EQ(said("CMake Error at CMakeLists.txt:4 (add_executable):\n  Cannot find source file:\n\n"
                 "    src/talker.cpp\n\n  Tried extensions .c\n\n\nCMake Generate step failed.\n")
                .message,
            before + "Cannot find source file: src/talker.cpp");
  // In a module of CMake's: the place is where the package called it.
  const Diagnostic found = said(
      "CMake Error at /usr/share/cmake/Modules/FindPackageHandleStandardArgs.cmake:230 (message):\n"
      "  Could NOT find PkgConfig (missing: PKG_CONFIG_EXECUTABLE)\nCall Stack (most recent call "
      "first):\n  /usr/share/cmake/Modules/FindPkgConfig.cmake:99 (find_package)\n"
      "  cmake/zmq.cmake:3 (include)\n  CMakeLists.txt:7 (include)\n\n\n"
      "-- Configuring incomplete, errors occurred!\n");
  EXPECT_EQ(found.message, before + "Could NOT find PkgConfig (missing: PKG_CONFIG_EXECUTABLE)");
  EXPECT_EQ(found.span->file, "src/demo/cmake/zmq.cmake");
  EXPECT_EQ(found.span->line, 3U);
  EXPECT_EQ(said("CMake Error: no place\n").message, "CMakeLists.txt of package `demo` failed");
}

TEST(OlderCMake, AskedVersionAndPlace) {
  const auto asked = asks_for_newer_cmake(
      "CMake Error at CMakeLists.txt:1 (cmake_minimum_required):\n"
      "  CMake 3.28.3 or higher is required.  You are running version 3.25.1\n\n\n"
      "-- Configuring incomplete, errors occurred!\n",
      kPlace);
  ASSERT_TRUE(asked);
  EXPECT_EQ(asked->there, "3.25.1");
  EXPECT_EQ(asked->warning.code, "R2W0529");
  EXPECT_NE(asked->warning.message.find("CMake 3.28.3"), std::string::npos);
  EXPECT_EQ(asked->warning.span->file, "CMakeLists.txt");  // it is kept with the package
  EXPECT_EQ(asked->warning.span->line, 1U);
  EXPECT_FALSE(asks_for_newer_cmake("CMake Error at CMakeLists.txt:1 (message):\n  no\n", kPlace));
}

TEST(OlderCMake, AsksForNoMoreThanThereIs) {
  EXPECT_EQ(for_older_cmake(
                "# x\nCMAKE_MINIMUM_REQUIRED( VERSION 3.28.3 FATAL_ERROR)\nproject(a)\n", "3.25.1"),
            "# x\nCMAKE_MINIMUM_REQUIRED( VERSION 3.25.1 FATAL_ERROR)\nproject(a)\n");
  EXPECT_EQ(for_older_cmake("cmake_minimum_required(VERSION 4.0...4.2)", "3.25.1"),
            "cmake_minimum_required(VERSION 3.25.1...4.2)");
  for (const char* same : {"cmake_minimum_required(VERSION 3.8...3.31)", "project(a VERSION 9.9)",
                           "cmake_minimum_required(VERSION 3.25.1)"})
    EXPECT_EQ(for_older_cmake(same, "3.25.1"), same);
}

// A package can hold and print anything: no long run of blanks, no number and no repetition may end
// or delay the tool.
TEST(OlderCMake, HostileFilesTakeNoTimeAndNoStack) {
  const std::string blanks(2'000'000, ' ');
  EXPECT_EQ(for_older_cmake("cmake_minimum_required" + blanks + "(VERSION 99.0)", "3.25.1"),
            "cmake_minimum_required" + blanks + "(VERSION 3.25.1)");
  std::string many = "cmake_minimum_required(VERSION 99.0)\n";
  for (int i = 0; i < 200'000; ++i) many += "#cmake_minimum_required(VERSION 9)\n";
  const auto began = std::chrono::steady_clock::now();
  EXPECT_EQ(for_older_cmake(many, "3.25.1").size(), many.size() + 2 + 200'000 * 5);
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(10));
}

TEST(CompileErrors, NumbersThatNoFileHasAreNoPlace) {
  const std::string large(30, '9');
  const auto errors =
      compile_errors("FAILED: a.o\ncc\nx.cpp:" + large + ":" + large + ": error: boo\n", kPlace);
  ASSERT_FALSE(errors.empty());
  EXPECT_EQ(printed_number(large), 0U);
  EXPECT_EQ(printed_number("12"), 12U);
  EXPECT_EQ(
      configure_errors("CMake Error at CMakeLists.txt:" + large + " (message):\n  boo\n", kPlace)
          .front()
          .code,
      "R2W0503");
  EXPECT_FALSE(asks_for_newer_cmake(
      "CMake Error at CMakeLists.txt:" + large + " (cmake_minimum_required):\n  boo\n", kPlace));
}

TEST(ConfigureErrors, AMissingPackageGetsTheLineForPackageXml) {
  const auto asked = [](const std::string& name) {
    return configure_errors(
               "CMake Error at CMakeLists.txt:8 (find_package):\n  asked CMake to find a package "
               "configuration file provided by\n  \"" +
                   name + "\", but CMake did not find one.\n",
               kPlace)
        .front();
  };
  EXPECT_EQ(asked("nav_msgs").code, "R2W0507");
  EXPECT_EQ(asked("nav_msgs").fix,
            std::vector<std::string>{"add `<depend>nav_msgs</depend>` to package.xml"});
  EXPECT_TRUE(asked("nav_msg").fix.empty());
  EXPECT_EQ(asked("nav_msg").why.back(), "the channels have `nav_msgs`");
}

TEST(DiagnosticJson, TravelsWhole) {
  const Diagnostics sent = {Diagnostic{.code = "R2W0504",
                                       .kind = FailureKind::kEnvironment,
                                       .message = "nothing defines `f(\"\\n\")`",
                                       .why = {"a", "b"},
                                       .fix = {"c"},
                                       .detail = "text\nmore"}};
  const Diagnostics received = diagnostics_from_json(diagnostics_to_json(sent));
  ASSERT_EQ(received.size(), 1U);
  EXPECT_EQ(received[0].code, sent[0].code);
  EXPECT_EQ(received[0].kind, sent[0].kind);
  EXPECT_EQ(received[0].message, sent[0].message);
  EXPECT_EQ(received[0].why, sent[0].why);
  EXPECT_EQ(received[0].fix, sent[0].fix);
  EXPECT_EQ(received[0].detail, sent[0].detail);
  EXPECT_TRUE(diagnostics_from_json("{not json").empty());
}

constexpr std::string_view kLacksHeader =
    "FAILED: tools/CMakeFiles/web.dir/src/web.cpp.o \n"
    "/usr/bin/em++ -c /ws/src/demo/src/web.cpp\n"
    "/ws/src/demo/src/web.cpp:5:10: fatal error: 'web/server.h' file not found\n"
    "#include \"web/server.h\"\n"
    "         ^~~~~~~~~~~~~~\n"
    "1 error generated.\n";

TEST(MissingHeaders, OfWhichProgramAndWhere) {
  const auto missing = missing_headers(kLacksHeader, kPlace);
  ASSERT_TRUE(missing);
  ASSERT_EQ(missing->size(), 1U);
  EXPECT_EQ(missing->front().target, "web");
  EXPECT_EQ(missing->front().header, "web/server.h");
  EXPECT_EQ(missing->front().place.file, "src/web.cpp");
  EXPECT_EQ(left_out_script(*missing),
            "ros2wasm_lacks_header([====[web]====] [====[the header `web/server.h` "
            "(src/web.cpp:5)]====])\n");
}

TEST(MissingHeaders, NoneWhenAnythingElseFails) {
  EXPECT_FALSE(missing_headers("", kPlace));
  EXPECT_FALSE(missing_headers(kNinja, kPlace));
  const std::string text(kLacksHeader);
  // Links speak for themselves.
  EXPECT_TRUE(missing_headers(text + "FAILED: web.wasm \nros2wasm link-program web.o\n", kPlace));
  EXPECT_FALSE(missing_headers(text + "/ws/src/demo/src/web.cpp:9:1: error: no\n", kPlace));
}

TEST(MissingHeaders, WhatSomebodyHasIsNotMissing) {
  const testing::TemporaryTree tree;
  tree.write("prefix/include/parts/parts/wheel.h", "");
  tree.write("source/include/own.h", "");
  BuildPlace place = kPlace;
  place.source = tree / "source";
  const auto given = [&](const std::string& header) {
    return is_given({.target = "a", .header = header, .place = {}}, place, {tree / "prefix"});
  };
  EXPECT_TRUE(given("parts/wheel.h"));
  EXPECT_TRUE(given("own.h"));
  EXPECT_TRUE(given("../own2.h"));
  EXPECT_TRUE(given("demo/own2.h"));
  EXPECT_TRUE(given("std_msgs/msg/no_such.hpp"));
  EXPECT_FALSE(given("web/server.h"));
}

TEST(MissingHeaders, AnInstalledPackageSaysWhatItLacks) {
  const testing::TemporaryTree tree;
  const auto missing = missing_headers(kLacksHeader, kPlace);
  EXPECT_TRUE(left_out_programs(tree.root(), kPlace).empty());
  ASSERT_TRUE(write_missing_headers(tree.root(), *missing));
  const Diagnostics warnings = left_out_programs(tree.root(), kPlace);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].code, "R2W0522");
  EXPECT_EQ(warnings[0].severity, Severity::kWarning);
  EXPECT_EQ(warnings[0].span->file, "src/demo/src/web.cpp");
  EXPECT_EQ(warnings[0].span->line, 5U);
  EXPECT_EQ(warnings[0].span->line_text, "#include \"web/server.h\"");
  BuildPlace later = kPlace;
  later.channel_packages.emplace_back("web");
  const Diagnostics errors = left_out_programs(tree.root(), later);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].code, "R2W0502");
  EXPECT_EQ(errors[0].severity, Severity::kError);
}

}  // namespace
}  // namespace ros2wasm
