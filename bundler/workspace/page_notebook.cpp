// See page_notebook.hpp.
#include "bundler/workspace/page_notebook.hpp"

#include <algorithm>
#include <set>
#include <string_view>

#include "bundler/workspace/page_text.hpp"
#include "bundler/workspace/python_imports.hpp"
#include "bundler/workspace/python_modules.hpp"
#include "workspace_schema/base/json_reader.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr DiagnosticCode kCode = "R2W0124";
/// With outputs that were saved with it.
constexpr std::size_t kMostBytes = std::size_t{8} << 20;
constexpr std::size_t kMostCells = 1000;
constexpr std::int64_t kVersion = 4;

/// nbformat writes a text as one string or as a list of lines with their ends.
std::string joined(const JsonValue* text) {
  if (text == nullptr) return {};
  if (const std::string* whole = text->string()) return *whole;
  std::string out;
  for (const JsonValue& line : text->items())
    if (const std::string* part = line.string()) out += *part;
  return out;
}

/// `%name`, `%%name` and `!command`; not the rest of an expression, such as `% n)` or `!= n`.
bool is_magic(std::string_view text) {
  if (text.size() < 2) return false;
  const char next = text[1];
  const bool is_letter = (next >= 'a' && next <= 'z') || (next >= 'A' && next <= 'Z');
  return (text.starts_with('%') && (is_letter || next == '%')) ||
         (text.starts_with('!') && next != '=');
}

/// Without what IPython reads and Python does not; lines keep their numbers.
std::string python_part(std::string_view source) {
  std::string out;
  bool first = true;
  while (!source.empty()) {
    const std::size_t end = std::min(source.find('\n'), source.size());
    const std::string_view line = source.substr(0, end);
    source.remove_prefix(std::min(end + 1, source.size()));
    const std::size_t begin = line.find_first_not_of(" \t");
    const std::string_view text = begin == std::string_view::npos ? "" : line.substr(begin);
    if (first && text.starts_with("%%")) return {};
    if (!text.empty()) first = false;
    if (!is_magic(text)) out += line;
    out += '\n';
  }
  return out;
}

Diagnostic no_notebook(const std::string& file, std::string why) {
  return Diagnostic{.code = kCode,
                    .message = "`" + file + "` is not a notebook that the page can show",
                    .why = {std::move(why)}};
}

}  // namespace

Outcome<NotebookCells> notebook_cells(std::string_view text, const std::string& file) {
  const auto json = parse_json(text, file, kCode);
  if (!json) return json.errors();
  const JsonValue* version = json->find("nbformat");
  const auto number = version == nullptr ? std::nullopt : version->integer();
  if (!number) return no_notebook(file, "it has no number `nbformat`");
  if (*number != kVersion)
    return no_notebook(file, "it is of nbformat " + std::to_string(*number) + "; the page reads 4");
  const JsonValue* cells = json->find("cells");
  if (cells == nullptr || !cells->is_array()) return no_notebook(file, "it has no list `cells`");
  if (cells->items().size() > kMostCells)
    return no_notebook(file, "it has more than " + std::to_string(kMostCells) + " cells");
  NotebookCells result;
  std::size_t at = 0;
  for (const JsonValue& cell : cells->items()) {
    const std::string type = cell.text_of("cell_type");
    std::string source = joined(cell.find("source"));
    ++at;
    if (type == "code") result.code.push_back({.number = at, .source = python_part(source)});
    if (type == "markdown") result.markdown.push_back({.number = at, .source = std::move(source)});
  }
  return result;
}

Outcome<PageNotebook> read_page_notebook(const fs::path& folder, const Spanned<std::string>& file) {
  PageNotebook notebook;
  auto files = read_with_images(
      folder, file, kMostBytes, [&](const std::string& bytes) -> Outcome<std::vector<std::string>> {
        auto cells = notebook_cells(bytes, file.value);
        if (!cells) {
          Diagnostics errors = cells.errors();
          for (Diagnostic& one : errors)
            if (!one.span) one.span = file.span;
          return errors;
        }
        notebook.code = std::move(cells->code);
        std::vector<std::string> images;
        for (const NotebookCell& cell : cells->markdown)
          for (std::string& image : markdown_images(cell.source))
            if (std::find(images.begin(), images.end(), image) == images.end())
              images.push_back(std::move(image));
        return images;
      });
  if (!files) return std::move(files).errors();
  notebook.files = std::move(*files);
  return notebook;
}

std::string cell_name(const std::string& file, const NotebookCell& cell) {
  return file + ", cell " + std::to_string(cell.number);
}

std::vector<Spanned<std::string>> notebook_modules(const std::string& file,
                                                   const std::vector<NotebookCell>& code) {
  std::vector<Spanned<std::string>> result;
  std::set<std::string> known;
  for (const NotebookCell& cell : code) {
    for (PythonImport& one : python_imports(cell.source, cell_name(file, cell))) {
      std::string name = one.module.substr(0, one.module.find('.'));
      const bool is_all_there = is_python_module(name) && needs_of_module(name).empty();
      if (!one.needed || name.empty() || is_all_there || !known.insert(name).second) continue;
      result.push_back({.value = std::move(name), .span = std::move(one.span)});
    }
  }
  return result;
}

}  // namespace ros2wasm
