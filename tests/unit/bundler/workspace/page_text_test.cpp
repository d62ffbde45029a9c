#include "bundler/workspace/page_text.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {
namespace fs = std::filesystem;
using Paths = std::vector<std::string>;

TEST(PageText, FindsInlineImagesOnce) {
  EXPECT_EQ(
      markdown_images("a ![x](a.png) ![](b/c.svg \"Title\")\n![y](a.png)![z](d%20e.png?raw=1)"),
      (Paths{"a.png", "b/c.svg", "d e.png"}));
}

TEST(PageText, LeavesOutCodeAddressesAndOtherForms) {
  EXPECT_EQ(markdown_images("`![x](a.png)` ``![x](`b.png)``\n```\n![x](c.png)\n~~~\n```\n"
                            "~~~~ md\n![x](d.png)\n~~~\n![x](e.png)\n~~~~\n"
                            "![x](https://host/f.png) ![x](//host/g.png) ![x](/h.png) ![x](#i)\n"
                            "![x](data:image/png,) \\![x](j.png) ![x][k] [x](l.png) ![x]( m.png)\n"
                            "![x](%zz.png) ![x](n%00.png) ![x](o.png p.png) ![x] (q.png) ![x](r"),
            Paths());
  EXPECT_EQ(markdown_images("a ` b ![x](a.png)"), Paths{"a.png"});
}

// Repetitions that made the search quadratic: a mebibyte took minutes.
TEST(PageText, HostileTextsTakeNoTime) {
  const auto repeated = [](const std::string& part, const std::string& end = {}) {
    std::string text;
    while (text.size() < 1'000'000) text += part;
    return text + end;
  };
  std::string many;
  for (int i = 0; many.size() < 1'000'000; ++i) many += "![](" + std::to_string(i) + ".png)";
  const auto began = std::chrono::steady_clock::now();
  EXPECT_TRUE(markdown_images(repeated("![a](")).empty());
  EXPECT_LT(markdown_images(repeated("![a](", ")")).size(), 1000U);  // the last ones have a path
  EXPECT_TRUE(markdown_images(repeated("![", "] x")).empty());
  EXPECT_TRUE(markdown_images(repeated("![") + "a](x" + std::string(500'000, ' ') + "z").empty());
  EXPECT_EQ(markdown_images(repeated("![") + "a](" + std::string(4000, 'x') + ")").size(), 1U);
  EXPECT_TRUE(markdown_images(repeated("a <!-- b\n")).empty());
  EXPECT_GT(markdown_images(many).size(), 50'000U);
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(20));
}

TEST(PageText, LeavesOutIndentedCodeAndComments) {
  EXPECT_EQ(markdown_images("    ![x](a.png)\n\n\t![x](b.png)\n    ![x](c.png)\n\nText\n"
                            "<!-- ![x](d.png) --> <!--\n![x](e.png)\n\n```\n--> \n"
                            "Words <!-- ![x](f.png)\n-->\n<!--\n![x](g.png)\n"),
            Paths());
  // A paragraph goes on, a list has such lines, and what is not a comment is text.
  EXPECT_EQ(markdown_images("Text\n    ![x](a.png)\n\n1. Item\n\n    ![x](b.png)\n\nText\n\n"
                            "    ![x](no.png)\n`<!--` ![x](c.png) \\`-->\n<!---->![x](d.png)\n"
                            "Words <!-- open ![x](e.png)"),
            (Paths{"a.png", "b.png", "c.png", "d.png", "e.png"}));
}

TEST(PageText, ReadsTheTextAndItsImages) {
  const testing::TemporaryTree tree;
  tree.write("lab/README.md", "![a](img/a.png) ![b](../b.svg)");
  tree.write("lab/img/a.png", "A");
  tree.write("b.svg", "B");
  const auto files = read_page_text(tree.root(), {.value = "./lab/README.md", .span = {}});
  ASSERT_TRUE(files.ok());
  ASSERT_EQ(files->size(), 3U);
  EXPECT_EQ((*files)[0].path, "lab/README.md");
  EXPECT_EQ((*files)[1].path, "lab/img/a.png");
  EXPECT_EQ((*files)[2].path, "b.svg");
  EXPECT_EQ((*files)[2].bytes, "B");
  EXPECT_EQ(page_text_path("./lab/README.md"), "text/lab/README.md");
}

TEST(PageText, RefusesWhatIsNotInTheFolder) {
  const testing::TemporaryTree outside;
  const testing::TemporaryTree tree;
  tree.write("README.md",
             "![a](../x.png)\n![b](gone.png)\n![c](link.png)\n![d](notes.txt)\n![e](%2e%2e/y.png)");
  tree.write("notes.txt", "N");
  fs::create_symlink(outside.write("secret.png", "S"), tree / "link.png");
  const auto files = read_page_text(tree.root(), {.value = "README.md", .span = {}});
  ASSERT_FALSE(files.ok());
  ASSERT_EQ(files.errors().size(), 5U);
  for (const Diagnostic& error : files.errors()) EXPECT_EQ(error.code, "R2W0118");
  EXPECT_EQ(files.errors()[0].message, "`../x.png` cannot be part of the page");
  EXPECT_EQ(files.errors()[1].why.front(), "there is no such file in the folder of the manifest");
  EXPECT_EQ(files.errors()[2].why.front(),
            "it is a link out of the folder of the manifest, or no file");
  for (const char* text : {"../README.md", "gone.md", ".", "sub/../../x.md"})
    EXPECT_FALSE(read_page_text(tree.root(), {.value = text, .span = {}}).ok()) << text;
}

}  // namespace
}  // namespace ros2wasm
