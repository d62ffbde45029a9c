// A fix is offered only when it is proven, so here every fix is done: in each bad manifest of the
// examples and of the golden tests, what a diagnostic says to write is written, and then that
// diagnostic must be gone and none be added.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "workspace_schema/schema/manifest_reader.hpp"

namespace ros2wasm {
namespace {

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Bad manifests by name.
std::vector<std::pair<std::string, std::string>> bad_manifests() {
  std::vector<std::pair<std::string, std::string>> found;
  const std::filesystem::path root = ROS2WASM_SOURCE_DIR;
  for (const auto& entry :
       std::filesystem::directory_iterator(root / "workspace_schema/schemas/examples/invalid")) {
    found.emplace_back(entry.path().filename(), read(entry.path()));
  }
  for (const auto& entry : std::filesystem::directory_iterator(root / "tests/golden/manifest")) {
    const std::string text = read(entry.path());
    const std::string mark = "--- file workspace.yaml\n";
    const std::size_t begin = text.find(mark);
    const std::size_t end = text.find("\n--- exit");
    if (begin == std::string::npos || end == std::string::npos) continue;
    found.emplace_back(entry.path().filename(),
                       text.substr(begin + mark.size(), end + 1 - begin - mark.size()));
  }
  std::sort(found.begin(), found.end());
  return found;
}

Diagnostics errors_of(const std::string& text) {
  const auto manifest = read_manifest(text, "workspace.yaml");
  return manifest ? Diagnostics{} : manifest.errors();
}

struct Lines {
  std::vector<std::string> all;

  explicit Lines(const std::string& text) {
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) all.push_back(line);
  }
  [[nodiscard]] std::string joined() const {
    std::string text;
    for (const std::string& line : all) text += line + "\n";
    return text;
  }
};

/// The texts that somebody might make of a fix; empty when the fix has another form.
std::vector<std::string> done(const std::string& text, const Diagnostic& error,
                              const std::string& fix) {
  std::vector<std::string> results;
  const SourceSpan& span = *error.span;
  const auto with_line = [&](std::size_t line, const std::string& replacement) {
    Lines lines(text);
    lines.all.at(line - 1) = replacement;
    results.push_back(lines.joined());
  };
  const std::size_t open = fix.find('`');
  const std::size_t close = fix.rfind('`');
  const std::string& line = span.line_text;
  const std::string indent = line.substr(0, line.find_first_not_of(" -"));
  if (fix.find("` beside `") != std::string::npos) return {};  // two places
  if (fix.starts_with("indent line ")) {
    const std::size_t by = std::stoul(fix.substr(fix.find(" by ") + 4));
    with_line(span.line, std::string(by, ' ') + line.substr(line.find_first_not_of(' ')));
  } else if (fix.starts_with("write line ")) {
    with_line(span.line, line.substr(line.find_first_not_of(' ')));
  } else if (fix.ends_with(" as the first line")) {
    results.push_back(fix.substr(open + 1, close - open - 1) + "\n" + text);
  } else if (fix.starts_with("write `") && fix.ends_with('`')) {
    const std::string written = fix.substr(open + 1, close - open - 1);
    const std::size_t start = span.column - 1;
    std::string replaced = line;
    results.push_back(text + written + "\n");                             // a key that is missing
    with_line(span.line, replaced.replace(start, span.length, written));  // what is underlined
    with_line(span.line, indent + written);                               // the line
    with_line(span.line, line.substr(0, start) + written);                // from the caret on
    const std::size_t colon = line.find(": ");  // the whole value, in its quotes or not
    if (colon != std::string::npos) {
      with_line(span.line, line.substr(0, colon + 2) + written);
      with_line(span.line, line.substr(0, colon + 2) + '"' + written + '"');
    }
    // The whole word, when the caret is inside of it.
    const std::size_t word_begin = line.find_last_of(" [{,\"", start == 0 ? 0 : start - 1);
    for (const std::string_view ends : {",]}\"", " "}) {
      const std::size_t from = word_begin == std::string::npos ? 0 : word_begin + 1;
      const std::size_t to = std::min(line.find_first_of(ends, start), line.size());
      with_line(span.line, line.substr(0, from) + written + line.substr(to));
    }
    for (const std::string_view sign : {":=", ": "}) {  // one side of a remapping
      const std::size_t at = line.find(sign);
      if (at == std::string::npos) continue;
      with_line(span.line, line.substr(0, at + sign.size()) + written);
      with_line(span.line, indent + written + line.substr(at));
    }
    if (const std::size_t at = line.find(": ");
        at != std::string::npos) {  // the key of a flow mapping
      const std::size_t brace = line.find('{');
      if (brace != std::string::npos)
        with_line(span.line, line.substr(0, brace + 1) + written + "}");
    }
  }
  return results;
}

bool contains(const Diagnostics& errors, const Diagnostic& wanted) {
  return std::any_of(errors.begin(), errors.end(), [&](const Diagnostic& error) {
    return error.code == wanted.code && error.message == wanted.message &&
           error.span == wanted.span;
  });
}

TEST(ProvenFixes, EveryFixHelps) {
  int fixes = 0;
  int other_forms = 0;
  for (const auto& [name, text] : bad_manifests()) {
    const Diagnostics errors = errors_of(text);
    for (const Diagnostic& error : errors) {
      if (error.severity != Severity::kError) continue;
      for (const std::string& fix : error.fix) {
        const auto candidates = done(text, error, fix);
        if (candidates.empty()) {
          ++other_forms;
          continue;
        }
        ++fixes;
        const bool helped =
            std::any_of(candidates.begin(), candidates.end(), [&](const std::string& candidate) {
              const Diagnostics left = errors_of(candidate);
              // A syntax error hides all others; when it is gone, those may show.
              return !contains(left, error) &&
                     (error.code == "R2W0101" || left.size() < errors.size());
            });
        EXPECT_TRUE(helped) << name << ": " << error.message << "\n  fix: " << fix;
      }
    }
  }
  EXPECT_GE(fixes, 60);
  EXPECT_LE(other_forms, 8);
}

}  // namespace
}  // namespace ros2wasm
