// Reads of a command to compile, and of the driver's own call of clang.
#include "bundler/build/direct_compile.hpp"

#include <gtest/gtest.h>

#include "unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

using Words = std::vector<std::string>;

const Words kCommand = {"em++",
                        "-DX=1",
                        "-Iinclude",
                        "-isystem",
                        "/p",
                        "-pthread",
                        "-O2",
                        "-std=c++17",
                        "-Wall",
                        "-MD",
                        "-MT",
                        "n.o",
                        "-MF",
                        "n.o.d",
                        "-include",
                        "/e.h",
                        "-ffile-prefix-map=/a=.",
                        "-o",
                        "n.o",
                        "-c",
                        "n.cpp"};

TEST(DirectCompile, TellsApartWhatTheDriverOnlyHandsOn) {
  const auto words = compile_words(kCommand);
  ASSERT_TRUE(words);
  EXPECT_EQ(words->source, "n.cpp");
  EXPECT_EQ(words->output, "n.o");
  EXPECT_EQ(words->manner, Words({"-pthread", "-O2", "-std=c++17"}));
}

TEST(DirectCompile, LeavesToTheDriverWhatIsNoCompilationOfOneSource) {
  const auto with = [](const Words& more) {
    Words words = kCommand;
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  EXPECT_TRUE(compile_words(with({"-Wno-unused"})));
  for (const Words& more : std::vector<Words>{{"m.cpp"},
                                              {"-E"},
                                              {"@flags"},
                                              {"-x", "c"},
                                              {"-o", "m.o"},
                                              {"-DTWO=\n"},
                                              {"-Xclang", "-include", "-Xclang", "a.h"}})
    EXPECT_FALSE(compile_words(with(more))) << more.front();
  EXPECT_FALSE(compile_words({"em++", "n.cpp", "-o", "n.o"}));
  EXPECT_FALSE(compile_words({"em++", "-c", "n.cpp"}));
  EXPECT_FALSE(compile_words({"em++", "-c", "n.S", "-o", "n.o"}));
}

TEST(DirectCompile, FindsWhatTheDriverPutsBeforeTheArguments) {
  const std::string printed =
      " \"/usr/bin/clang++-14\" -target wasm32 \"-DA=b c\" -v -pthread -O2 -c /t/e.cpp -o /t/e.o\n"
      " \"/usr/lib/clang\" -cc1 -triple wasm32 -O2 -o /t/e.o -x c++ /t/e.cpp\n";
  EXPECT_EQ(parse_compiler_call(printed, {"-pthread", "-O2"}, "/t/e.cpp", "/t/e.o"),
            Words({"/usr/bin/clang++-14", "-target", "wasm32", "-DA=b c"}));
}

TEST(DirectCompile, LeavesToTheDriverArgumentsThatItChanges) {
  const std::string printed = "\"clang++\" -target wasm32 -v -O3 -c e.cpp -o e.o\n";
  EXPECT_FALSE(parse_compiler_call(printed, {"-O4"}, "e.cpp", "e.o"));
  EXPECT_FALSE(parse_compiler_call(printed, {}, "e.cpp", "e.o"));
  EXPECT_FALSE(parse_compiler_call("", {"-O3"}, "e.cpp", "e.o"));
  EXPECT_FALSE(
      parse_compiler_call("ccache \"clang++\" -v -O3 -c e.cpp -o e.o", {"-O3"}, "e.cpp", "e.o"));
}

TEST(DirectCompile, AsksADriverOnceForEachManner) {
  const testing::TemporaryTree tree;
  const std::string driver = tree.write("em++",
                                        "#!/bin/sh\n"
                                        "echo asked >> \"$0.log\"\n"
                                        "echo \"/bin/clang++ -target wasm32 $*\"\n")
                                 .string();
  std::filesystem::permissions(driver, std::filesystem::perms::owner_all);
  const auto direct = [&](const Words& arguments) {
    Words command = {driver};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return direct_compile_command(command, tree / "kept", {}, {});
  };
  const Words first = {"-O2", "-Ia", "-c", "n.cpp", "-o", "n.o"};
  const Words expected = {"/bin/clang++", "-target", "wasm32", "-O2", "-Ia",
                          "-c",           "n.cpp",   "-o",     "n.o"};
  EXPECT_EQ(direct(first), expected);
  EXPECT_EQ(direct(first), expected);
  EXPECT_EQ(direct({"-O2", "-Ib", "-c", "m.cpp", "-o", "m.o"}).front(), "/bin/clang++");
  EXPECT_EQ(tree.read("em++.log"), "asked\n");
  EXPECT_EQ(direct({"-O3", "-c", "m.cpp", "-o", "m.o"}).front(), "/bin/clang++");
  EXPECT_EQ(tree.read("em++.log"), "asked\nasked\n");
}

TEST(DirectCompile, CallsTheDriverWhenItCannotBeAsked) {
  const testing::TemporaryTree tree;
  const Words command = {"/none/em++", "-c", "n.cpp", "-o", "n.o"};
  EXPECT_EQ(direct_compile_command(command, tree / "kept", {}, {}), command);
  EXPECT_EQ(direct_compile_command(command, "", {}, {}), command);
}

}  // namespace
}  // namespace ros2wasm
