// Reads of the driver's own call of the linker, and of arguments that only the driver understands.
#include "bundler/build/direct_link.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

using Words = std::vector<std::string>;

constexpr const char* kOptimizer = "wasm-opt -O2 /t/p.wasm -o /t/p.wasm -g\n";

TEST(DirectLink, FindsTheCallsOfTheToolsAmongWhatTheDriverPrints) {
  const auto calls = parse_tool_calls(
      " \"/usr/bin/clang++-14\" -c x.cpp\n"
      " \"/usr/bin/wasm-ld-14\" -o /t/p.wasm --wrap=pthread_create /t/p.o -L/lib -lc -o other\n"
      " \"wasm-emscripten-finalize\" /t/p.wasm\n"
      " \"/usr/bin/wasm-opt\" --post-emscripten -O2 /t/p.wasm -o /t/p.wasm -g --mvp-features "
      "--enable-threads\n",
      "/t/p.o", "/t/p.wasm");
  ASSERT_TRUE(calls);
  EXPECT_EQ(calls->linker, Words({"/usr/bin/wasm-ld-14", "--wrap=pthread_create"}));
  EXPECT_EQ(calls->after, Words({"-L/lib", "-lc", "-o", "other"}));
  const Words& optimizer = calls->optimizer;
  ASSERT_GT(optimizer.size(), 4U);
  EXPECT_EQ(Words(optimizer.begin(), optimizer.begin() + 3),
            Words({"/usr/bin/wasm-opt", "--post-emscripten", "--optimize-level=2"}));
  EXPECT_EQ(Words(optimizer.end() - 2, optimizer.end()), Words({"-g", "--strip-target-features"}));
}

TEST(DirectLink, LeavesToTheOptimizerAnotherLevelThanItsUsualOne) {
  const auto calls = parse_tool_calls(
      "\"wasm-ld\" -o p.wasm p.o\n\"wasm-opt\" -Oz p.wasm -o p.wasm\n", "p.o", "p.wasm");
  ASSERT_TRUE(calls);
  EXPECT_EQ(calls->optimizer, Words({"wasm-opt", "-Oz", "--strip-target-features"}));
}

TEST(DirectLink, FindsNoCallsWithoutTheMarkerOrTheOptimizer) {
  const std::string linker = "\"wasm-ld\" -o p.wasm p.o\n";
  EXPECT_TRUE(parse_tool_calls(linker + kOptimizer, "p.o", "p.wasm"));
  EXPECT_FALSE(parse_tool_calls(linker + kOptimizer, "q.o", "p.wasm"));
  EXPECT_FALSE(parse_tool_calls(linker, "p.o", "p.wasm"));
  EXPECT_FALSE(parse_tool_calls("", "p.o", "p.wasm"));
}

TEST(DirectLink, LeavesToTheDriverWhatCallsTheOptimizerTwice) {
  const std::string linker = "\"wasm-ld\" -o p.wasm p.o\n";
  EXPECT_FALSE(parse_tool_calls(linker + kOptimizer + kOptimizer, "p.o", "p.wasm"));
}

TEST(DirectLink, GivesTheLinkerWhatIsMeantForIt) {
  EXPECT_EQ(linker_arguments({"-O2", "a.o", "-Xlinker", "--wrap=sleep", "-Wl,-z,stack-size=9",
                              "-Wl,--whole-archive", "liba.a", "-L/x", "-lb", "-Wall", "-g"}),
            Words({"a.o", "--wrap=sleep", "-z", "stack-size=9", "--whole-archive", "liba.a", "-L/x",
                   "-lb"}));
}

TEST(DirectLink, LeavesToTheDriverWhatOnlyItUnderstands) {
  EXPECT_FALSE(linker_arguments({"a.o", "-sSTACK_SIZE=1MB"}));
  EXPECT_FALSE(linker_arguments({"main.cpp"}));
  EXPECT_FALSE(linker_arguments({"a.o", "--preload-file", "data"}));
}

}  // namespace
}  // namespace ros2wasm
