// Robustness: readers of hostile text neither crash nor hang, and every diagnostic they give is
// well formed. ROS2WASM_FUZZ_ROUNDS in the environment asks for more rounds than the quick default.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "workspace_schema/base/text_encoding.hpp"
#include "workspace_schema/schema/manifest_json.hpp"
#include "workspace_schema/schema/manifest_reader.hpp"
#include "workspace_schema/schema/package_xml.hpp"

namespace ros2wasm {
namespace {

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<std::string> seeds(const std::filesystem::path& folder, const std::string& extension) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == extension) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> texts;
  for (const auto& path : paths) texts.push_back(read(path));
  return texts;
}

int rounds(int usual) {
  const char* asked = std::getenv("ROS2WASM_FUZZ_ROUNDS");
  return asked == nullptr ? usual : std::atoi(asked);
}

class Mutator {
 public:
  Mutator(std::uint32_t seed, std::vector<std::string> pieces)
      : random_(seed), pieces_(std::move(pieces)) {}

  std::size_t below(std::size_t limit) { return limit == 0 ? 0 : random_() % limit; }

  std::string mutated(std::string text, const std::vector<std::string>& others) {
    const std::size_t changes = 1 + below(4);
    for (std::size_t i = 0; i < changes; ++i) change(text, others);
    return text;
  }

 private:
  void change(std::string& text, const std::vector<std::string>& others) {
    const std::size_t at = below(text.size() + 1);
    const std::size_t length = std::min(below(12), text.size() - at);
    switch (below(7)) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, pieces_[below(pieces_.size())]);
        break;
      case 2:
        text.replace(at, length, pieces_[below(pieces_.size())]);
        break;
      case 3:
        text.insert(at, text.substr(below(text.size() + 1), below(40)));
        break;
      case 4:
        if (at < text.size()) text[at] = static_cast<char>(random_());
        break;
      case 5:
        text.resize(at);
        break;
      default: {
        const std::string& other = others[below(others.size())];
        text.replace(at, length, other.substr(below(other.size() + 1), below(60)));
      }
    }
  }

  std::mt19937 random_;
  std::vector<std::string> pieces_;
};

void expect_well_formed(const Diagnostics& diagnostics, const std::string& input) {
  ASSERT_FALSE(diagnostics.empty());
  for (const Diagnostic& diagnostic : diagnostics) {
    ASSERT_FALSE(diagnostic.code.empty()) << input;
    ASSERT_FALSE(diagnostic.message.empty()) << input;
    ASSERT_TRUE(diagnostic.span.has_value()) << input;
    const SourceSpan& span = *diagnostic.span;
    ASSERT_GE(span.line, 1U) << input;
    ASSERT_GE(span.column, 1U) << input;
    // Where the line is known, the caret lies in it or right behind it.
    if (!span.line_text.empty() && span.line_text.size() < 4096) {
      ASSERT_LE(span.column - 1 + span.length, span.line_text.size() + 1) << input;
    }
  }
}

TEST(Mutation, ManifestReader) {
  const auto texts = seeds(ROS2WASM_SOURCE_DIR "/workspace_schema/schemas/examples", ".yaml");
  ASSERT_GE(texts.size(), 40U);
  Mutator mutator(20240523, {"\t",
                             "\n",
                             "\r\n",
                             " ",
                             "  ",
                             ":",
                             ": ",
                             "- ",
                             "-",
                             "[",
                             "]",
                             "{",
                             "}",
                             ",",
                             "\"",
                             "'",
                             "&a ",
                             "*a",
                             "!!str ",
                             "!",
                             "|",
                             ">",
                             "|\n",
                             "#",
                             "? ",
                             "---\n",
                             "...\n",
                             "%YAML 1.2\n",
                             "~",
                             "null",
                             "\xEF\xBB\xBF",
                             "\xC3\xA9",
                             "\xFF",
                             std::string(1, '\0'),
                             "\\",
                             "\\x",
                             "0x",
                             "1e999",
                             ".nan",
                             "<<: ",
                             "@",
                             "`",
                             "name:",
                             "launch:",
                             "schema: 1\n",
                             "\xE2\x80\xA8",
                             "\x85",
                             "\x04"});
  for (int round = rounds(6000); round > 0; --round) {
    const std::string input = mutator.mutated(texts[mutator.below(texts.size())], texts);
    const auto manifest = read_manifest(input, "workspace.yaml");
    if (manifest) {
      ASSERT_FALSE(manifest_json(*manifest).empty());
    } else {
      expect_well_formed(manifest.errors(), input);
    }
    if (HasFatalFailure()) return;
  }
}

TEST(Mutation, PackageXmlReader) {
  const auto texts = seeds(ROS2WASM_SOURCE_DIR "/examples", ".xml");
  ASSERT_GE(texts.size(), 2U);
  Mutator mutator(20240524, {"<",
                             ">",
                             "</",
                             "/>",
                             "\"",
                             "'",
                             "<a>",
                             "</a>",
                             "<!--",
                             "-->",
                             "<![CDATA[",
                             "]]>",
                             "<?xml?>",
                             "&amp;",
                             "&#x0;",
                             "&#xFFFFFFFF;",
                             "&x;",
                             "<!DOCTYPE a [",
                             "]>",
                             "condition=\"$A == 1\"",
                             "=",
                             " ",
                             "\n",
                             "\xFF",
                             std::string(1, '\0'),
                             "<package format=\"3\">",
                             "<depend>",
                             "</depend>"});
  for (int round = rounds(6000); round > 0; --round) {
    const std::string input = mutator.mutated(texts[mutator.below(texts.size())], texts);
    const auto package = parse_package_xml(input, "package.xml", ros_condition_variables("jazzy"));
    if (!package) expect_well_formed(package.errors(), input);
    if (HasFatalFailure()) return;
  }
}

TEST(Mutation, Conditions) {
  Mutator mutator(7, {"$", "==", "!=", "<", "<=", "and", " or ", "(", ")", "\"", "'", " ", "a",
                      "$ROS_VERSION"});
  const std::vector<std::string> texts{"$ROS_VERSION == 2",
                                       "($A == 1 or $B != 'x') and $ROS_DISTRO >= \"humble\""};
  const auto variables = ros_condition_variables("jazzy");
  for (int round = rounds(6000); round > 0; --round) {
    const std::string input = mutator.mutated(texts[mutator.below(texts.size())], texts);
    const auto once = evaluate_condition(input, variables);
    ASSERT_EQ(once, evaluate_condition(input, variables)) << input;
  }
}

}  // namespace
}  // namespace ros2wasm
