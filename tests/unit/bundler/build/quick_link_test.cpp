// Reads of the driver's own call of the linker, and of arguments that only the driver understands.
#include "bundler/build/quick_link.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

using Words = std::vector<std::string>;

TEST(QuickLink, FindsTheCallOfTheLinkerAmongWhatTheDriverPrints) {
  const auto call = parse_linker_call(
      " \"/usr/bin/clang++-14\" -c x.cpp\n"
      " \"/usr/bin/wasm-ld-14\" -o /t/p.wasm --wrap=pthread_create /t/p.o -L/lib -lc -o other\n"
      " \"wasm-emscripten-finalize\" /t/p.wasm\n",
      "/t/p.o", "/t/p.wasm");
  ASSERT_TRUE(call);
  EXPECT_EQ(call->linker, "/usr/bin/wasm-ld-14");
  EXPECT_EQ(call->before, Words({"--wrap=pthread_create"}));
  EXPECT_EQ(call->after, Words({"-L/lib", "-lc", "-o", "other"}));
}

TEST(QuickLink, FindsNoCallWithoutTheMarker) {
  EXPECT_FALSE(parse_linker_call("\"wasm-ld\" -o p.wasm q.o\n", "p.o", "p.wasm"));
  EXPECT_FALSE(parse_linker_call("", "p.o", "p.wasm"));
}

TEST(QuickLink, GivesTheLinkerWhatIsMeantForIt) {
  EXPECT_EQ(linker_arguments({"-O2", "a.o", "-Xlinker", "--wrap=sleep", "-Wl,-z,stack-size=9",
                              "-Wl,--whole-archive", "liba.a", "-L/x", "-lb", "-Wall", "-g"}),
            Words({"a.o", "--wrap=sleep", "-z", "stack-size=9", "--whole-archive", "liba.a", "-L/x",
                   "-lb"}));
}

TEST(QuickLink, LeavesToTheDriverWhatOnlyItUnderstands) {
  EXPECT_FALSE(linker_arguments({"a.o", "-sSTACK_SIZE=1MB"}));
  EXPECT_FALSE(linker_arguments({"main.cpp"}));
  EXPECT_FALSE(linker_arguments({"a.o", "--preload-file", "data"}));
}

}  // namespace
}  // namespace ros2wasm
