// For which sources the header of rclcpp may be read ahead.
#include "bundler/build/cached_header.hpp"

#include <gtest/gtest.h>

#include "unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

using Words = std::vector<std::string>;

class KeptHeader : public ::testing::Test {
 protected:
  KeptHeader() {
    tree.write("env/include/rclcpp/rclcpp/rclcpp.hpp", "");
    tree.write("env/include/std_msgs/std_msgs/msg/string.hpp", "");
  }
  [[nodiscard]] Words command(const Words& more = {}) const {
    Words words = {"em++",     "-Iinclude", "-isystem", (tree / "env/include/rclcpp").string(),
                   "-isystem", "/other",    "-O2",      "-std=gnu++17",
                   "-MD",      "-MT",       "n.o",      "-MF",
                   "n.o.d",    "-o",        "n.o",      "-c",
                   "n.cpp"};
    words.insert(words.begin() + 1, more.begin(), more.end());
    return words;
  }
  /// begins_with_header() for a source with this text, which finds its own headers in `own`.
  [[nodiscard]] bool begins(const std::string& text) const {
    return begins_with_header({.source = tree.write("own/n.cpp", text),
                               .own_folders = {tree / "own"},
                               .packages = tree / "env/include",
                               .flags = {}});
  }

  testing::TemporaryTree tree;
};

TEST_F(KeptHeader, TakesFromACommandWhatTheHeaderDependsOn) {
  const auto use = header_use(command({"-DX=1", "-DA_DLL", "-DCLASS_LOADER_LIBRARY=\"l.so\"",
                                       "-ffile-prefix-map=/a=.", "-include", "/t/e.h"}));
  ASSERT_TRUE(use);
  EXPECT_EQ(use->source, "n.cpp");
  EXPECT_EQ(use->packages, tree / "env/include");
  EXPECT_EQ(use->own_folders, (std::vector<std::filesystem::path>{"include", "/other"}));
  EXPECT_EQ(use->flags, Words({"-DX=1", "-include", "/t/e.h", "-O2", "-std=gnu++17"}));
}

TEST_F(KeptHeader, LeavesOtherCommandsAlone) {
  EXPECT_FALSE(header_use({"em++", "-c", "n.cpp"}));  // without rclcpp
  EXPECT_FALSE(header_use(command({"-E"})));
  EXPECT_FALSE(header_use(command({"@flags"})));
  EXPECT_FALSE(header_use(command({"m.cpp"})));
  EXPECT_FALSE(header_use(command({"-include-pch", "p"})));
  EXPECT_FALSE(header_use(command({"-include", "config.h"})));
  Words in_c = command();
  in_c.back() = "n.c";
  EXPECT_FALSE(header_use(in_c));
  Words links = command();
  links.erase(links.end() - 2);
  EXPECT_FALSE(header_use(links));
}

TEST_F(KeptHeader, SourcesThatBeginWithIt) {
  EXPECT_TRUE(begins("#include <rclcpp/rclcpp.hpp>\n"));
  EXPECT_TRUE(
      begins("// A node\n\n \n#include <chrono>\n# include \"rclcpp/rclcpp.hpp\"\n#define X\n"));
  EXPECT_TRUE(
      begins("/* #define X\n*/ #include<memory>\n#include\"rclcpp/rclcpp.hpp\" // yes\r\n"));
  tree.write("own/p/node.hpp", "#ifndef P\n#define P\n#include \"p/base.hpp\"\nclass N;\n#endif\n");
  tree.write("own/p/base.hpp", "#pragma once\n#include \"rclcpp/rclcpp.hpp\"\n");
  EXPECT_TRUE(begins("#include \"p/node.hpp\"\n"));
  tree.write("own/p/round.hpp", "#include \"p/round.hpp\"\n#include \"rclcpp/rclcpp.hpp\"\n");
  EXPECT_TRUE(begins("#include <p/round.hpp>\n"));
}

TEST_F(KeptHeader, SourcesThatDoNot) {
  EXPECT_FALSE(begins(""));
  EXPECT_FALSE(begins("int main() {}\n"));
  EXPECT_FALSE(begins("// #include \"rclcpp/rclcpp.hpp\"\n"));
  EXPECT_FALSE(begins("#define _USE_MATH_DEFINES\n#include \"rclcpp/rclcpp.hpp\"\n"));
  EXPECT_FALSE(begins("#ifdef A\n#include \"rclcpp/rclcpp.hpp\"\n#endif\n"));
  EXPECT_FALSE(begins("#pragma pack(1)\n#include \"rclcpp/rclcpp.hpp\"\n"));
  EXPECT_FALSE(begins("#include HEADER\n#include \"rclcpp/rclcpp.hpp\"\n"));
  EXPECT_FALSE(begins("int before = 1;\n\n#include \"rclcpp/rclcpp.hpp\"\n"));
  tree.write("own/config.hpp", "#pragma once\n#define private public\n");
  EXPECT_FALSE(begins("#include \"config.hpp\"\n#include \"rclcpp/rclcpp.hpp\"\n"));
}

}  // namespace
}  // namespace ros2wasm
