#include "bundler/workspace/python_imports.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

/// "module: name name", with a `?` in front of what the file can do without.
std::vector<std::string> told(std::string_view text) {
  std::vector<std::string> result;
  for (const PythonImport& one : python_imports(text, "a.py")) {
    std::string line = (one.needed ? "" : "?") + one.module;
    for (const std::string& name : one.names)
      line += (&name == &one.names.front() ? ": " : " ") + name;
    result.push_back(line);
  }
  return result;
}

using Lines = std::vector<std::string>;

TEST(PythonImports, ReadsAllForms) {
  EXPECT_EQ(
      told("import a\nimport b.c as d, e ; import f\nfrom g.h import i\nfrom j import (k as l,\n"
           "    m,  # why\n)\nfrom n import o, \\\n  p\nfrom . import q\nfrom ..r.s import t\n"
           "from u import *\nfrom .v import w"),
      (Lines{"a", "b.c", "e", "f", "g.h: i", "j: k m", "n: o p", ".: q", "..r.s: t", "u: *",
             ".v: w"}));
}

TEST(PythonImports, LeavesOutTextsCommentsAndOtherWords) {
  EXPECT_EQ(told("\"\"\"import a\nimport b\n\"\"\"\nx = '''\nimport c'''\n# import d\n"
                 "y = 'import e' \"\\\"import f\"\nimporting = 1\nz.import_(g)\nraise E from h\n"
                 "yield from i\nf(\nimport_=1)\n"
                 "r'\\'\nimport j"),
            Lines{"j"});
}

TEST(PythonImports, KnowsWhatAFileCanDoWithout) {
  EXPECT_EQ(told("try:\n  import a\nexcept ImportError:\n  import b\nimport c\nif TYPE_CHECKING:\n"
                 "  import d\ndef f():\n  import e\nclass G:\n  import g\n  async def h(self):\n"
                 "    import i\n  import j\nif x: import k\nwith y:\n\timport l\nimport m"),
            (Lines{"?a", "?b", "c", "?d", "?e", "g", "?i", "j", "?k", "l", "m"}));
}

TEST(PythonImports, KnowsWhatIsUsedOfAWholeModule) {
  const auto found = python_imports(
      "import a\nimport b as c, d.e\nfrom f import g\nx = a.one(c.two, b.three)\n"
      "def h():\n  return q.a.four + a.five.six + 'a.seven'  # a.eight\n  a.one()\n",
      "a.py");
  ASSERT_EQ(found.size(), 4U);
  EXPECT_EQ(found[0].attributes, (Lines{"five", "one"}));
  EXPECT_EQ(found[1].attributes, Lines{"two"});
  EXPECT_TRUE(found[2].attributes.empty());
  EXPECT_TRUE(found[3].attributes.empty());
}

TEST(PythonImports, KnowsThePlace) {
  const auto found = python_imports("x = 1\nfrom  geometry_msgs.msg  import Twist\n", "src/a.py");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].span.file, "src/a.py");
  EXPECT_EQ(found[0].span.line, 2U);
  EXPECT_EQ(found[0].span.column, 7U);
  EXPECT_EQ(found[0].span.length, 17U);
  EXPECT_EQ(found[0].span.line_text, "from  geometry_msgs.msg  import Twist");
}

TEST(PythonImports, ComesToAnEndOnBrokenFiles) {
  for (const char* text :
       {"import", "from", "from a", "from a import", "import a.", "(((\nimport a", "'''import a",
        "\"\\", "import a,", "from . import", "\\"}) {
    EXPECT_LE(python_imports(text, "a.py").size(), 1U) << text;
  }
}

TEST(PythonImports, KnowsPythonsOwnModules) {
  EXPECT_TRUE(is_python_module("json"));
  EXPECT_TRUE(is_python_module("tkinter"));
  EXPECT_TRUE(is_lacking_python_module("tkinter"));
  EXPECT_FALSE(is_lacking_python_module("json"));
  EXPECT_FALSE(is_python_module("numpy"));
}

TEST(PythonScript, IsToldByItsFirstLine) {
  EXPECT_TRUE(is_python_script("#!/usr/bin/env python3\nimport a"));
  EXPECT_FALSE(is_python_script("#!/bin/sh\n# python"));
  EXPECT_FALSE(is_python_script("import a"));
}

}  // namespace
}  // namespace ros2wasm
