// See diagnostic_text.hpp.
#include "cli/diagnostic_text.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include "workspace_schema/base/json_writer.hpp"
#include "workspace_schema/base/text_encoding.hpp"

namespace ros2wasm {
namespace {

constexpr std::size_t kTabWidth = 4;
constexpr std::string_view kEllipsis = "\xE2\x80\xA6";

enum class Paint { kError, kWarning, kNote, kBold, kFrame, kFix };

std::string painted(std::string_view text, Paint paint, bool color) {
  if (!color || text.empty()) return std::string(text);
  std::string_view code;
  switch (paint) {
    case Paint::kError:
      code = "\x1b[1;31m";
      break;
    case Paint::kWarning:
      code = "\x1b[1;33m";
      break;
    case Paint::kNote:
      code = "\x1b[1;36m";
      break;
    case Paint::kBold:
      code = "\x1b[1m";
      break;
    case Paint::kFrame:
      code = "\x1b[1;34m";
      break;
    case Paint::kFix:
      code = "\x1b[1;32m";
      break;
  }
  return std::string(code) + std::string(text) + "\x1b[0m";
}

std::string_view severity_word(Severity severity) {
  switch (severity) {
    case Severity::kError:
      return "error";
    case Severity::kWarning:
      return "warning";
    case Severity::kNote:
      return "note";
  }
  return "error";
}

Paint severity_paint(Severity severity) {
  switch (severity) {
    case Severity::kError:
      return Paint::kError;
    case Severity::kWarning:
      return Paint::kWarning;
    case Severity::kNote:
      return Paint::kNote;
  }
  return Paint::kError;
}

std::string_view kind_word(FailureKind kind) {
  switch (kind) {
    case FailureKind::kUserInput:
      return "user_input";
    case FailureKind::kCommandLine:
      return "command_line";
    case FailureKind::kEnvironment:
      return "environment";
    case FailureKind::kBug:
      return "bug";
    case FailureKind::kInterrupted:
      return "interrupted";
  }
  return "bug";
}

/// C0, DEL, C1 and the characters that turn the writing direction: files must not steer the
/// terminal.
bool steers_terminal(char32_t c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0) || (c >= 0x202A && c <= 0x202E) ||
         (c >= 0x2066 && c <= 0x2069);
}

/// `text` with characters that steer the terminal shown as <hex>; newlines and tabs stay when
/// asked.
std::string harmless(std::string_view raw, bool keep_lines) {
  const std::string text = valid_utf8(raw);
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const Utf8Character character = decode_utf8(text, i);
    const bool line_character = character.code_point == '\n' || character.code_point == '\t';
    if (steers_terminal(character.code_point) && !(keep_lines && line_character)) {
      constexpr std::string_view kHex = "0123456789ABCDEF";
      out += '<';
      if (character.code_point > 0xFF) {
        out += kHex[(character.code_point >> 12U) & 0xFU];
        out += kHex[(character.code_point >> 8U) & 0xFU];
      }
      out += kHex[(character.code_point >> 4U) & 0xFU];
      out += kHex[character.code_point & 0xFU];
      out += '>';
    } else {
      out += text.substr(i, character.length);
    }
    i += character.length;
  }
  return out;
}

/// One character of a source line as it is drawn.
struct Cell {
  std::string text;
  std::size_t width = 0;
  std::size_t byte = 0;  ///< offset in the source line
};

std::vector<Cell> cells_of(std::string_view line) {
  std::vector<Cell> cells;
  std::size_t column = 0;
  for (std::size_t i = 0; i < line.size();) {
    const Utf8Character character = decode_utf8(line, i);
    Cell cell{.byte = i};
    if (character.valid && character.code_point == '\t') {
      cell.width = kTabWidth - column % kTabWidth;
      cell.text = std::string(cell.width, ' ');
    } else if (!character.valid || steers_terminal(character.code_point)) {
      cell.width = 1;
      cell.text = "\xEF\xBF\xBD";
    } else {
      cell.width = terminal_width(character.code_point);
      cell.text = std::string(line.substr(i, character.length));
    }
    column += cell.width;
    i += character.length;
    cells.push_back(std::move(cell));
  }
  return cells;
}

std::size_t width_of(const std::vector<Cell>& cells, std::size_t first, std::size_t last) {
  std::size_t width = 0;
  for (std::size_t i = first; i < last; ++i) width += cells[i].width;
  return width;
}

/// The drawn line, how far right the carets start, and how many there are.
struct Excerpt {
  std::string text;
  std::size_t caret_offset = 0;
  std::size_t caret_count = 1;
};

Excerpt excerpt_of(const SourceSpan& span, std::size_t room) {
  const std::vector<Cell> cells = cells_of(span.line_text);
  const std::size_t start_byte = span.column == 0 ? 0 : span.column - 1;
  const std::size_t end_byte = start_byte + std::max<std::size_t>(span.length, 1);
  const auto index_of = [&](std::size_t byte) {
    const auto at =
        std::find_if(cells.begin(), cells.end(), [&](const Cell& c) { return c.byte >= byte; });
    return static_cast<std::size_t>(at - cells.begin());
  };
  const std::size_t start = index_of(start_byte);
  const std::size_t end = std::max(start, index_of(end_byte));

  std::size_t first = 0;
  std::size_t last = cells.size();
  if (width_of(cells, 0, cells.size()) > room) {
    // Keep the caret in sight: as much as fits from a little before it.
    const std::size_t lead = room / 3;
    first = start;
    while (first > 0 && width_of(cells, first - 1, start) <= lead) --first;
    last = first;
    std::size_t width = 0;
    while (last < cells.size() && width + cells[last].width <= room - 2)
      width += cells[last++].width;
    while (last == cells.size() && first > 0 && width + cells[first - 1].width <= room - 2) {
      width += cells[--first].width;
    }
  }
  Excerpt excerpt;
  if (first > 0) excerpt.text += kEllipsis;
  for (std::size_t i = first; i < last; ++i) excerpt.text += cells[i].text;
  if (last < cells.size()) excerpt.text += kEllipsis;
  while (!excerpt.text.empty() && excerpt.text.back() == ' ') excerpt.text.pop_back();
  excerpt.caret_offset = (first > 0 ? 1 : 0) + width_of(cells, first, std::max(first, start));
  excerpt.caret_count =
      std::max<std::size_t>(1, width_of(cells, start, std::min(end, std::max(last, start))));
  return excerpt;
}

/// `= why: text`, with the following lines of a multi-line text set under its beginning.
void append_remark(std::string& out, std::string_view indent, std::string_view word,
                   std::string_view raw, Paint paint, bool color) {
  const std::string text = harmless(raw, true);
  out += indent;
  out += painted(" = ", Paint::kFrame, color);
  out += painted(std::string(word) + ":", paint, color);
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (begin > 0) out += std::string(indent) + std::string(word.size() + 4, ' ');
    if (end > begin) out += ' ' + text.substr(begin, end - begin);
    out += '\n';
    begin = end + 1;
  }
}

}  // namespace

std::string diagnostic_text(const Diagnostic& diagnostic, const TextStyle& style) {
  const bool color = style.color;
  const Paint paint = severity_paint(diagnostic.severity);
  std::string out = painted(
      std::string(severity_word(diagnostic.severity)) + "[" + diagnostic.code + "]", paint, color);
  out += painted(": " + harmless(diagnostic.message, false), Paint::kBold, color);
  out += '\n';

  std::string indent = "  ";
  if (diagnostic.span.has_value()) {
    const SourceSpan& span = *diagnostic.span;
    const std::string number = std::to_string(span.line);
    if (span.line > 0) indent = std::string(number.size(), ' ');
    out += indent + painted("--> ", Paint::kFrame, color) + harmless(span.file, false);
    if (span.line > 0) out += ":" + number;
    if (span.line > 0 && span.column > 0) out += ":" + std::to_string(span.column);
    out += '\n';
    if (span.line > 0 && span.column > 0 && !span.line_text.empty()) {
      const std::size_t frame = indent.size() + 3;
      const std::size_t room = std::max<std::size_t>(style.width, frame + 40) - frame;
      const Excerpt excerpt = excerpt_of(span, room);
      out += painted(number + " |", Paint::kFrame, color);
      if (!excerpt.text.empty()) out += " " + excerpt.text;
      out += "\n" + indent + painted(" |", Paint::kFrame, color) + " ";
      out += std::string(excerpt.caret_offset, ' ');
      std::string carets(excerpt.caret_count, '^');
      if (!diagnostic.label.empty()) carets += " " + harmless(diagnostic.label, false);
      out += painted(carets, paint, color);
      out += '\n';
    } else if (!diagnostic.label.empty()) {
      append_remark(out, indent, "here", diagnostic.label, Paint::kNote, color);
    }
  }
  for (const std::string& why : diagnostic.why)
    append_remark(out, indent, "why", why, Paint::kBold, color);
  for (const std::string& fix : diagnostic.fix)
    append_remark(out, indent, "fix", fix, Paint::kFix, color);
  if (!diagnostic.detail.empty()) {
    const std::string detail = harmless(diagnostic.detail, true);
    std::size_t begin = 0;
    while (begin < detail.size()) {
      const std::size_t end = std::min(detail.find('\n', begin), detail.size());
      if (end > begin) out += "    " + detail.substr(begin, end - begin);
      out += '\n';
      begin = end + 1;
    }
  }
  return out;
}

std::string diagnostic_json(const Diagnostic& diagnostic) {
  JsonWriter json;
  json.begin_object();
  json.field("event", "diagnostic");
  json.field("code", diagnostic.code);
  json.field("severity", severity_word(diagnostic.severity));
  json.field("kind", kind_word(diagnostic.kind));
  json.field("message", diagnostic.message);
  json.key("span");
  if (diagnostic.span.has_value()) {
    const SourceSpan& span = *diagnostic.span;
    json.begin_object();
    json.field("file", span.file);
    json.field_integer("line", span.line);
    json.field_integer("column", span.column);
    json.field_integer("length", span.length);
    json.field("line_text", span.line_text);
    json.end_object();
  } else {
    json.null();
  }
  json.field("label", diagnostic.label);
  json.key("why").begin_array();
  for (const std::string& why : diagnostic.why) json.string(why);
  json.end_array();
  json.key("fix").begin_array();
  for (const std::string& fix : diagnostic.fix) json.string(fix);
  json.end_array();
  json.field("detail", diagnostic.detail);
  json.end_object();
  return json.text();
}

}  // namespace ros2wasm
