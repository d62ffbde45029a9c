// See material_script.hpp.
#include "sdf/material_script.hpp"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace ros2wasm_sim {
namespace {

using Words = std::vector<std::string>;

/// Without `// ...` and `/* ... */`.
std::string without_comments(const std::string& text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    if (text.compare(at, 2, "//") == 0) {
      at = std::min(text.find('\n', at), text.size());
    } else if (text.compare(at, 2, "/*") == 0) {
      const std::size_t end = text.find("*/", at + 2);
      at = end == std::string::npos ? text.size() : end + 2;
    } else {
      result += text[at++];
    }
  }
  return result;
}

/// The lines of a script; a brace is a line of its own.
std::vector<Words> lines_of(const std::string& text) {
  std::vector<Words> lines(1);
  std::string word;
  const auto end_word = [&] {
    if (!word.empty()) lines.back().push_back(std::move(word));
    word.clear();
  };
  const auto end_line = [&] {
    end_word();
    if (!lines.back().empty()) lines.emplace_back();
  };
  bool is_quoted = false;
  for (const char c : without_comments(text)) {
    if (c == '"') {
      is_quoted = !is_quoted;
    } else if (c == '\n' || c == '\r') {
      is_quoted = false;
      end_line();
    } else if (!is_quoted && (c == '{' || c == '}')) {
      end_line();
      lines.back().push_back(std::string(1, c));
      end_line();
    } else if (!is_quoted && (c == ' ' || c == '\t')) {
      end_word();
    } else {
      word += c;
    }
  }
  end_line();
  lines.pop_back();
  return lines;
}

Color color_of(const Words& line, const Color& alternative) {
  if (line.size() < 4) return alternative;
  const auto part = [&](std::size_t i) { return std::strtod(line[i].c_str(), nullptr); };
  return {part(1), part(2), part(3), line.size() > 4 ? part(4) : 1};
}

}  // namespace

std::optional<ScriptMaterial> find_material(const std::string& script, const std::string& name) {
  std::optional<ScriptMaterial> found;
  int depth = 0;
  int passes = 0;
  for (const Words& line : lines_of(script)) {
    const std::string& key = line.front();
    if (key == "{") ++depth;
    if (key == "}" && --depth == 0 && found) return found;
    if (!found) {
      if (depth == 0 && key == "material" && line.size() > 1 && line[1] == name) found.emplace();
      continue;
    }
    if (key == "pass") ++passes;
    if (passes > 1) continue;
    if (key == "ambient") found->ambient = color_of(line, found->ambient);
    if (key == "diffuse") found->diffuse = color_of(line, found->diffuse);
    if (key == "emissive") found->emissive = color_of(line, found->emissive);
    if (key == "texture" && line.size() > 1 && found->texture.empty()) found->texture = line[1];
  }
  return found;
}

}  // namespace ros2wasm_sim
