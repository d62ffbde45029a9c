// Which files of an installation come along for Python nodes: none by a link that leads out.
#include "bundler/workspace/python_tree.hpp"

#include <gtest/gtest.h>

#include "bundler/workspace/installed_tree.hpp"
#include "tests/unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {
namespace fs = std::filesystem;

TEST(PythonTree, LinksThatLeadOutAreLeftOut) {
  const testing::TemporaryTree tree;
  tree.write("outside/id_rsa", "secret");
  const std::string modules = std::string(kPythonModules) + "/demo/";
  tree.write("prefix/" + modules + "a.py", "a");
  const std::string compiled = modules + "__pycache__/a.cpython-312.pyc";
  const std::string by_hash("\xcb\x0d\x0d\x0a\x03\x00\x00\x00hash, code", 18);
  tree.write("prefix/" + compiled, by_hash);
  tree.write("prefix/" + modules + "__pycache__/b.cpython-312.pyc",
             std::string("\xcb\x0d\x0d\x0a\x00\x00\x00\x00time, code", 18));
  tree.write("prefix/" + modules + "__pycache__/c.cpython-311.pyc",
             std::string("\xa7\x0d\x0d\x0a\x03\x00\x00\x00hash, code", 18));
  tree.write("prefix/" + modules + "a.cpython-312.pyc", "");
  fs::create_symlink("a.py", tree / ("prefix/" + modules + "same.py"));
  fs::create_symlink(tree / "outside/id_rsa", tree / ("prefix/" + modules + "key.py"));
  fs::create_directory_symlink(tree / "outside", tree / ("prefix/" + modules + "more"));
  PythonFiles files;
  const auto left_out = collect_python_modules(tree / "prefix", files);
  ASSERT_TRUE(left_out);
  EXPECT_EQ(files, (PythonFiles{
                       {compiled, by_hash}, {modules + "a.py", "a"}, {modules + "same.py", "a"}}));
  EXPECT_EQ(*left_out,
            (LeftOut{modules + "key.py" + kLeadsElsewhere, modules + "more" + kLeadsElsewhere}));

  tree.write("prefix/lib/demo/run", "r");
  fs::create_symlink(tree / "outside/id_rsa", tree / "prefix/lib/demo/notes");
  PythonFiles scripts;
  EXPECT_EQ(*collect_python_scripts(tree / "prefix", "demo", scripts),
            LeftOut{std::string("lib/demo/notes") + kLeadsElsewhere});
  EXPECT_EQ(scripts, (PythonFiles{{"lib/demo/run", "r"}}));
  const auto programs = installed_programs(tree / "prefix", "demo");
  ASSERT_EQ(programs.size(), 1U);
  EXPECT_EQ(programs[0].executable, "run");

  fs::create_directory_symlink(tree / "outside", tree / "prefix/lib/other");
  PythonFiles others;
  EXPECT_EQ(*collect_python_scripts(tree / "prefix", "other", others),
            LeftOut{std::string("lib/other") + kLeadsElsewhere});
  EXPECT_TRUE(others.empty());
}

TEST(PythonTree, DefinitionsByLinksThatLeadOutAreNone) {
  const testing::TemporaryTree tree;
  tree.write("outside", "string secret");
  tree.write("prefix/share/demo/msg/Num.msg", "int32 x");
  fs::create_symlink(tree / "outside", tree / "prefix/share/demo/msg/Key.msg");
  InterfaceTexts texts;
  collect_interfaces(tree / "prefix", "demo", texts);
  EXPECT_EQ(texts, (InterfaceTexts{{"demo/msg/Num", "int32 x"}}));
}

}  // namespace
}  // namespace ros2wasm
