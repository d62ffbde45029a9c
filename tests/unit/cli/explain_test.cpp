// Every code has a page, and every page has a code: read off the sources, so that neither can be
// forgotten.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "cli/embedded_texts.hpp"

namespace ros2wasm {
namespace {

const std::filesystem::path kRoot = ROS2WASM_SOURCE_DIR;

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Calls `use` with the place and the text of each code.
template <typename Use>
void for_each_code(const std::string& text, const Use& use) {
  constexpr std::string_view kBegin = "R2W";
  constexpr std::size_t kDigits = 4;
  for (std::size_t at = text.find(kBegin); at != std::string::npos;
       at = text.find(kBegin, at + 1)) {
    const std::string digits = text.substr(at + kBegin.size(), kDigits);
    if (digits.size() == kDigits && digits.find_first_not_of("0123456789") == std::string::npos)
      use(at, std::string(kBegin) + digits);
  }
}

/// Codes in string literals and JSON of the program and of the site, each with one file that has
/// it.
std::map<std::string, std::string> codes_in_sources() {
  static const std::set<std::string> kExtensions{".cpp", ".hpp", ".ts",   ".tsx",
                                                 ".mjs", ".h",   ".html", ".py"};
  std::map<std::string, std::string> codes;
  for (const char* folder : {"cli", "bundler", "workspace_schema", "runtime"}) {
    if (!std::filesystem::exists(kRoot / folder)) continue;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kRoot / folder)) {
      if (!kExtensions.contains(entry.path().extension().string())) continue;
      const std::string text = read(entry.path());
      for_each_code(text, [&](std::size_t at, const std::string& code) {
        constexpr std::string_view kBefore = "\"'`>[";
        if (at > 0 && kBefore.find(text[at - 1]) != std::string_view::npos)
          codes.emplace(code, entry.path().lexically_relative(kRoot).string());
      });
    }
  }
  return codes;
}

TEST(Explain, EveryCodeHasAPage) {
  std::set<std::string> pages;
  for (const EmbeddedText& page : explain_pages()) pages.emplace(page.name);
  const auto codes = codes_in_sources();
  ASSERT_GE(codes.size(), 30U);
  for (const auto& [code, file] : codes) {
    EXPECT_TRUE(pages.contains(code))
        << file << " uses " << code << ": write cli/explain/" << code << ".md";
  }
}

/// Codes that any test but this one names.
std::set<std::string> codes_in_tests() {
  std::set<std::string> codes;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kRoot / "tests")) {
    if (!entry.is_regular_file() || entry.path().filename() == "explain_test.cpp") continue;
    const std::string text = read(entry.path());
    for_each_code(text, [&](std::size_t, const std::string& code) { codes.insert(code); });
  }
  return codes;
}

TEST(Explain, EveryCodeHasATest) {
  const auto tested = codes_in_tests();
  for (const auto& [code, file] : codes_in_sources()) {
    EXPECT_TRUE(tested.contains(code)) << file << " uses " << code << ", and no test names it";
  }
}

TEST(Explain, EveryPageHasACode) {
  const auto codes = codes_in_sources();
  for (const EmbeddedText& page : explain_pages()) {
    EXPECT_TRUE(codes.contains(std::string(page.name)))
        << "nothing uses " << page.name << ": remove its page";
  }
}

TEST(Explain, PagesHaveTheirForm) {
  for (const EmbeddedText& page : explain_pages()) {
    const std::string first(page.text.substr(0, page.text.find('\n')));
    EXPECT_TRUE(first.starts_with("# " + std::string(page.name) + ": ")) << first;
    const auto lines = std::count(page.text.begin(), page.text.end(), '\n');
    EXPECT_GE(lines, 3) << page.name << ": what, why, how to fix";
    EXPECT_LE(lines, 40) << page.name;
    EXPECT_TRUE(page.text.ends_with('\n')) << page.name;
  }
}

TEST(Explain, SchemasAreEmbedded) {
  ASSERT_EQ(json_schemas().size(), 3U);
  EXPECT_EQ(json_schemas()[2].text, read(kRoot / "workspace_schema/schemas/workspace.schema.json"));
}

}  // namespace
}  // namespace ros2wasm
