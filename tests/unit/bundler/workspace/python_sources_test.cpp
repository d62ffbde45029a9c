// Which files of a workspace are the sources of what was installed.
#include "bundler/workspace/python_sources.hpp"

#include <gtest/gtest.h>

#include "unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

TEST(PythonSources, AreFoundByNameAndBytes) {
  const testing::TemporaryTree tree;
  tree.write("work/src/demo/demo/talker.py", "talk");
  tree.write("work/src/demo/demo/__init__.py", "");
  tree.write("work/src/demo/scripts/judge.py", "judge");
  tree.write("work/src/demo/scripts/run", "#!/usr/bin/env python3\n");
  tree.write("work/src/demo/notes", "no program");
  tree.write("work/src/demo/demo/other.py", "changed since");
  tree.write("beside/extra/extra.py", "beside");
  const std::string modules = std::string(kPythonModules) + "/demo/";
  const PythonFiles installed = {
      {modules + "talker.py", "talk"},  {modules + "__init__.py", ""},
      {modules + "other.py", "built"},  {modules + "extra.py", "beside"},
      {"lib/demo/judge.py", "judge"},   {"lib/demo/run", "#!/usr/bin/env python3\n"},
      {"lib/demo/notes", "no program"}, {"lib/demo/talker", "#!python\nmade of an entry point"},
  };
  const PythonSources expected = {
      {modules + "talker.py", "src/demo/demo/talker.py"},
      {modules + "extra.py", "../beside/extra/extra.py"},
      {"lib/demo/judge.py", "src/demo/scripts/judge.py"},
      {"lib/demo/run", "src/demo/scripts/run"},
  };
  EXPECT_EQ(
      python_sources(installed, {tree / "work/src/demo", tree / "beside/extra"}, tree / "work"),
      expected);
}

TEST(PythonSources, OfSeveralAlikeTheOneWhosePathAgreesLongest) {
  const testing::TemporaryTree tree;
  tree.write("src/a/tools/node.py", "same");
  tree.write("src/a/one/node.py", "same");
  tree.write("src/a/build/deeper/one/node.py", "same");
  tree.write("src/a/.hidden/one/node.py", "same");
  tree.write("src/a/install/COLCON_IGNORE", "");
  tree.write("src/a/install/" + std::string(kPythonModules) + "/one/node.py", "same");
  const std::string path = std::string(kPythonModules) + "/one/node.py";
  EXPECT_EQ(python_sources({{path, "same"}}, {tree / "src/a"}, tree.root()),
            (PythonSources{{path, "src/a/one/node.py"}}));
}

}  // namespace
}  // namespace ros2wasm
