// Folders of sites and courses against their lists: what is not in a list, and lists that are far
// too long.
#include "bundler/verify/site_check.hpp"

#include <gtest/gtest.h>

#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/site/own_site.hpp"
#include "bundler/verify/course_check.hpp"
#include "unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

const std::string kEmptySite = R"({"generator":"ros2wasm 0.1.0","files":[]})";

/// A site without files of its own.
void write_empty_site(const testing::TemporaryTree& tree, const std::string& folder) {
  tree.write(folder + "/site.json", kEmptySite);
  tree.write(folder + "/SHA256SUMS", sha256_hex(kEmptySite) + "  site.json\n");
}

TEST(SiteCheck, FilesThatNoListHas) {
  const testing::TemporaryTree tree;
  write_empty_site(tree, "site");
  tree.write("site/evil.js", "x");
  tree.write("site/a.gz", "x");
  tree.write("site/channel/noarch/repodata.json", "x");
  tree.write("site/channel/noarch/a-1-0.conda", "x");
  tree.write("site/channel/noarch/index.html", "x");
  tree.write("site/channel/page.svg", "x");
  tree.write("site/site.json.minisig", "x");
  std::filesystem::create_symlink("site.json", tree / "site/link");
  const auto check = check_site_folder(tree / "site", {}, {});
  ASSERT_TRUE(check);
  EXPECT_TRUE(check->faults.empty());
  EXPECT_EQ(check->unlisted, (std::vector<std::string>{"a.gz", "channel/noarch/index.html",
                                                       "channel/page.svg", "evil.js", "link"}));
  const Diagnostic warning = unlisted_files(check->unlisted, "site");
  EXPECT_EQ(warning.code, "R2W0653");
  EXPECT_EQ(warning.severity, Severity::kWarning);
  EXPECT_EQ(unlisted_files(std::vector<std::string>(9, "a"), "s").why.back(), "and 4 more");
}

// Guarantee, hostile input: a file of a site that is larger than its list says is not read
TEST(SiteCheck, AFileOfATerabyteIsAFault) {
  const testing::TemporaryTree tree;
  const std::string json = R"({"generator":"ros2wasm 0.1.0","files":[{"path":"a.js","size":1,)"
                           R"("sha256":")" +
                           sha256_hex("x") + R"("}]})";
  tree.write("site/site.json", json);
  tree.write("site/a.js", "x");
  const auto good = check_site_folder(tree / "site", {}, {});
  ASSERT_TRUE(good);
  std::filesystem::resize_file(tree / "site/a.js", std::uintmax_t{1} << 40U);
  const auto check = check_site_folder(tree / "site", {}, {});
  ASSERT_TRUE(check);
  ASSERT_EQ(check->faults.size(), good->faults.size() + 1);
  EXPECT_EQ(check->faults.front().code, "R2W0650");
  EXPECT_EQ(check->faults.front().why.front(), "it has 1099511627776 bytes, site.json says 1");
}

/// A course of one lab, `one`, whose page is "x".
void write_course(const testing::TemporaryTree& tree) {
  write_empty_site(tree, "course/one");
  const std::string json =
      R"({"generator":"ros2wasm 0.1.0","labs":[{"name":"one","sha256":")" + sha256_hex(kEmptySite) +
      R"("}],"files":[{"path":"index.html","size":1,"sha256":")" + sha256_hex("x") + R"("}]})";
  tree.write("course/index.html", "x");
  tree.write("course/course.json", json);
  tree.write("course/SHA256SUMS", sha256_hex(json) + "  course.json\n" + sha256_hex("x") +
                                      "  index.html\n" + sha256_hex(kEmptySite) +
                                      "  one/site.json\n");
}

std::vector<std::string> faults_of_course(const testing::TemporaryTree& tree) {
  const auto check = check_course_folder(tree / "course", {}, {});
  std::vector<std::string> messages;
  for (const Diagnostic& fault : check ? check->faults : check.errors())
    messages.push_back(fault.code + ": " + fault.message);
  return messages;
}

// Guarantee, verified: files in the folder of a course that neither the course nor a lab lists are
// named
TEST(SiteCheck, FilesBesideTheLabsOfACourse) {
  const testing::TemporaryTree tree;
  write_course(tree);
  tree.write("course/one/more", "x");
  tree.write("course/evil.js", "x");
  tree.write("course/two/index.html", "x");
  const auto check = check_course_folder(tree / "course", {}, {});
  ASSERT_TRUE(check);
  EXPECT_TRUE(check->faults.empty());
  EXPECT_EQ(check->unlisted, (std::vector<std::string>{"evil.js", "one/more", "two/index.html"}));
}

// Guarantee, verified: the compressed forms of a course's own files unpack to these files, and its
// SHA256SUMS has the hashes of all files
TEST(SiteCheck, FormsAndHashesOfACourse) {
  const testing::TemporaryTree tree;
  write_course(tree);
  EXPECT_EQ(faults_of_course(tree), std::vector<std::string>());
  tree.write("course/index.html.gz", "another page");
  tree.write("course/course.json.br", "x");
  EXPECT_EQ(faults_of_course(tree),
            (std::vector<std::string>{
                "R2W0650: `index.html.gz` is not the file that the course was packed with",
                "R2W0650: `course.json.br` is not the file that the course was packed with"}));
  std::filesystem::remove(tree / "course/index.html.gz");
  std::filesystem::remove(tree / "course/course.json.br");
  tree.write("course/SHA256SUMS", std::string(64, 'a') + "  index.html\n");
  EXPECT_EQ(faults_of_course(tree),
            std::vector<std::string>{
                "R2W0650: `SHA256SUMS` is not the file that the course was packed with"});
}

// Guarantee, verified: a course.json cannot hide a changed site: a folder with a site.json is
// checked as a site, and a course must list its page and a lab
TEST(SiteCheck, ACourseJsonHidesNothing) {
  const testing::TemporaryTree tree;
  write_course(tree);
  EXPECT_TRUE(is_course_of_ours(tree / "course"));
  tree.write("course/one/course.json", R"({"generator":"ros2wasm 0.1.0","labs":[],"files":[]})");
  EXPECT_FALSE(is_course_of_ours(tree / "course/one"));
  tree.write("course/course.json", R"({"generator":"ros2wasm 0.1.0","labs":[],"files":[]})");
  EXPECT_TRUE(faults_of_course(tree).front().starts_with("R2W0605"));
  tree.write("course/course.json",
             R"({"generator":"ros2wasm 0.1.0","labs":[{"name":"one","sha256":")" +
                 sha256_hex(kEmptySite) + R"("}],"files":[]})");
  EXPECT_TRUE(faults_of_course(tree).front().starts_with("R2W0605"));
}

// Guarantee, hostile input: when a site.json lists hundreds of thousands of missing files, `verify`
// names the first thousand and stops
TEST(SiteCheck, StopsAtAThousandFaults) {
  const testing::TemporaryTree tree;
  std::string files;
  for (int i = 0; i < 3000; ++i)
    files += std::string(i == 0 ? "" : ",") + R"({"path":"f)" + std::to_string(i) +
             R"(","size":1,"sha256":")" + std::string(64, 'a') + "\"}";
  tree.write("site/site.json", R"({"generator":"ros2wasm 0.1.0","files":[)" + files + "]}");
  const auto check = check_site_folder(tree / "site", {}, {});
  ASSERT_TRUE(check);
  EXPECT_EQ(check->faults.size(), 1001U);
  EXPECT_EQ(check->faults.back().message, "the other files were not looked at");
}

}  // namespace
}  // namespace ros2wasm
