#include "bundler/workspace/page_notebook.hpp"

#include <gtest/gtest.h>

#include "unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

constexpr const char* kLab = R"json({"nbformat": 4, "nbformat_minor": 5, "metadata": {}, "cells": [
  {"cell_type": "markdown", "metadata": {}, "source": ["# Lab\n", "![a](a.png)"]
},
  {"cell_type": "code", "metadata": {}, "outputs": [], "execution_count": null,
   "source": "import rclpy, sys\n%matplotlib inline\n!ls\nfrom std_msgs.msg import String\nx = 5 %\\\n  2"},
  {"cell_type": "code", "source": ["%%bash\n", "import nothing"]},
  {"cell_type": "code", "source": ["try:\n", "    import matplotlib\n", "except ImportError: pass\n", "import rclpy.node"]},
  {"cell_type": "raw", "source": "import no_code"}]
})json";

std::string problem_of(const std::string& text) {
  const auto cells = notebook_cells(text, "lab.ipynb");
  EXPECT_FALSE(cells.ok()) << text;
  if (cells.ok()) return {};
  EXPECT_EQ(cells.errors().front().code.text(), "R2W0124");
  return cells.errors().front().why.front();
}

TEST(PageNotebook, FindsTheCells) {
  const auto cells = notebook_cells(kLab, "lab.ipynb");
  ASSERT_TRUE(cells.ok());
  ASSERT_EQ(cells->markdown.size(), 1U);
  EXPECT_EQ(cells->markdown[0].source, "# Lab\n![a](a.png)");
  ASSERT_EQ(cells->code.size(), 3U);
  EXPECT_EQ(cells->code[0].number, 2U);
  // Lines of IPython are empty, the others keep their numbers.
  EXPECT_TRUE(cells->code[0].source.starts_with(
      "import rclpy, sys\n\n\nfrom std_msgs.msg import String\nx = 5 %"))
      << cells->code[0].source;
  EXPECT_EQ(cells->code[1].source, "");
  EXPECT_EQ(cell_name("lab.ipynb", cells->code[2]), "lab.ipynb, cell 4");
}

TEST(PageNotebook, TellsWhatItsCodeImports) {
  const auto cells = notebook_cells(kLab, "lab.ipynb");
  ASSERT_TRUE(cells.ok());
  const auto modules = notebook_modules("lab.ipynb", cells->code);
  ASSERT_EQ(modules.size(), 2U);
  EXPECT_EQ(modules[0].value, "rclpy");
  EXPECT_EQ(modules[0].span.file, "lab.ipynb, cell 2");
  EXPECT_EQ(modules[1].value, "std_msgs");
  EXPECT_EQ(modules[1].span.line, 4U);
}

// Guarantee, hostile input: a file that is not a notebook is refused when it is packed, with what
// it is instead
TEST(PageNotebook, RefusesWhatIsNone) {
  EXPECT_EQ(problem_of("[]"), "it has no number `nbformat`");
  EXPECT_EQ(problem_of(R"({"nbformat": "4"})"), "it has no number `nbformat`");
  EXPECT_EQ(problem_of(R"({"nbformat": 3, "worksheets": []})"),
            "it is of nbformat 3; the page reads 4");
  EXPECT_EQ(problem_of(R"({"nbformat": 4, "cells": {}})"), "it has no list `cells`");
  EXPECT_FALSE(problem_of("{").empty());
  EXPECT_FALSE(problem_of(std::string(300, '[') + std::string(300, ']')).empty());
  std::string many = R"({"nbformat": 4, "cells": [0)";
  for (int i = 0; i < 1000; ++i) many += ",0";
  EXPECT_EQ(problem_of(many + "]}"), "it has more than 1000 cells");
}

TEST(PageNotebook, BringsTheImagesOfItsMarkdown) {
  const testing::TemporaryTree tree;
  tree.write("lab/lab.ipynb", kLab);
  tree.write("lab/a.png", "A");
  const auto notebook = read_page_notebook(tree.root(), {.value = "lab/lab.ipynb", .span = {}});
  ASSERT_TRUE(notebook.ok());
  ASSERT_EQ(notebook->files.size(), 2U);
  EXPECT_EQ(notebook->files[1].path, "lab/a.png");
  EXPECT_EQ(notebook->code.size(), 3U);
  EXPECT_EQ(read_page_notebook(tree.root(), {.value = "none.ipynb", .span = {}})
                .errors()
                .front()
                .code.text(),
            "R2W0118");
}

}  // namespace
}  // namespace ros2wasm
