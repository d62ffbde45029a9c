// See yaml_syntax_hint.hpp.
#include "workspace_schema/base/yaml_syntax_hint.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include "workspace_schema/base/yaml_scalar.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kBlank = " \t";

std::size_t indent_of(std::string_view line) {
  return std::min(line.find_first_not_of(kBlank), line.size());
}

bool is_blank_or_comment(std::string_view line) {
  const std::size_t indent = indent_of(line);
  return indent == line.size() || line[indent] == '#';
}

std::string spaces(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " space" : " spaces");
}

/// Where a line's key or value begins behind `- ` marks.
std::size_t content_start(std::string_view line) {
  std::size_t at = indent_of(line);
  while (at + 1 < line.size() && line[at] == '-' && line[at + 1] == ' ') {
    at = std::min(line.find_first_not_of(' ', at + 1), line.size());
  }
  return at;
}

/// Offset of the value in `key: value`, behind the first ": "; npos when the line has no such form.
std::size_t value_start(std::string_view line) {
  const std::size_t start = content_start(line);
  if (start < line.size() && (line[start] == '"' || line[start] == '\''))
    return std::string_view::npos;
  const std::size_t colon = line.find(": ", start);
  if (colon == std::string_view::npos) return colon;
  return line.find_first_not_of(' ', colon + 1);
}

std::string_view trimmed_end(std::string_view text) {
  const std::size_t last = text.find_last_not_of(" \t\r");
  return last == std::string_view::npos ? std::string_view() : text.substr(0, last + 1);
}

class Hint {
 public:
  Hint(const SourceText& source, const YamlSyntaxReport& report, const FirstYamlError& first_error)
      : source_(source), report_(report), first_error_(first_error) {
    place_ = source_.span(report_.offset, 1);
    line_ = place_.line;
    // At the end of the text, or on a blank line, the last line with something on it is the
    // interesting one.
    while (line_ > 1 && is_blank_or_comment(source_.line_text(line_))) --line_;
    text_ = source_.line_text(line_);
  }

  Diagnostic diagnose() {
    if (auto found = tab()) return *found;
    if (auto found = open_quote()) return *found;
    if (auto found = open_bracket()) return *found;
    if (auto found = no_space_after_colon()) return *found;
    if (auto found = list_behind_key()) return *found;
    if (auto found = value_needs_quotes()) return *found;
    if (auto found = word_needs_quotes()) return *found;
    if (auto found = odd_indentation()) return *found;
    return plain();
  }

 private:
  [[nodiscard]] Diagnostic at(std::size_t line, std::size_t column, std::size_t length,
                              std::string message, std::string label = {}) const {
    return Diagnostic{
        .code = "R2W0101",
        .message = std::move(message),
        .span = source_.span(source_.line_start(line) + column, std::max<std::size_t>(length, 1)),
        .label = std::move(label)};
  }

  /// True when the text with line `line` replaced parses, or fails only behind that line.
  [[nodiscard]] bool helps(std::size_t line, const std::string& replacement) const {
    const std::size_t start = source_.line_start(line);
    const std::size_t length = source_.line_text(line).size();
    std::string text(source_.text().substr(0, start));
    text += replacement;
    const std::size_t end = text.size();
    text += source_.text().substr(start + length);
    const std::size_t error = first_error_(text);
    return error == std::string_view::npos ||
           (error > end && error + length > report_.offset + replacement.size());
  }

  std::optional<Diagnostic> tab() const {
    for (const std::size_t line : {place_.line + 0U, place_.line + 1U}) {
      const std::string_view text = source_.line_text(line);
      const std::size_t tab_at = text.substr(0, indent_of(text)).find('\t');
      if (tab_at == std::string_view::npos || indent_of(text) == text.size()) continue;
      Diagnostic found = at(line, tab_at, 1, "a tab is used to indent a line", "a tab");
      found.why.push_back("YAML allows only spaces there: how wide a tab is depends on the editor");
      std::string replacement(text);
      for (std::size_t i = replacement.find('\t'); i < indent_of(replacement);
           i = replacement.find('\t')) {
        replacement.replace(i, 1, "  ");
      }
      if (helps(line, replacement)) found.fix.push_back("replace each tab by 2 spaces");
      return found;
    }
    return std::nullopt;
  }

  /// A quote or bracket that is open where the library gave up.
  struct Open {
    std::size_t offset = 0;
    char mark = 0;
  };

  /// Walks the text up to `end` with quotes, comments and flow brackets in mind.
  [[nodiscard]] std::optional<Open> open_at(std::size_t end) const {
    const std::string_view text = source_.text();
    std::vector<Open> open;
    for (std::size_t i = 0; i < end; ++i) {
      const char c = text[i];
      const char before = i == 0 ? '\n' : text[i - 1];
      const bool free = std::string_view(" \t\r\n[{,").find(before) != std::string_view::npos;
      if (c == '#' && std::string_view(" \t\n").find(before) != std::string_view::npos) {
        i = std::min(text.find('\n', i), end);
      } else if ((c == '"' || c == '\'') && free) {
        std::size_t close = i + 1;
        while (close < text.size() && text[close] != c)
          close += c == '"' && text[close] == '\\' ? 2 : 1;
        if (close >= text.size()) return Open{i, c};
        i = close;
      } else if ((c == '[' || c == '{') && (free || !open.empty())) {
        open.push_back({i, c});
      } else if ((c == ']' || c == '}') && !open.empty()) {
        open.pop_back();
      }
    }
    return open.empty() ? std::nullopt : std::optional(open.back());
  }

  std::optional<Diagnostic> open_quote() const {
    const auto open = open_at(source_.text().size());
    if (!open || (open->mark != '"' && open->mark != '\'')) return std::nullopt;
    const SourceSpan span = source_.span(open->offset, 1);
    Diagnostic found =
        at(span.line, span.column - 1, 1, "a quote is not closed", "it begins here and has no end");
    const std::string replacement = std::string(trimmed_end(span.line_text)) + open->mark;
    if (helps(span.line, replacement)) {
      found.fix.push_back("write `" + replacement.substr(span.column - 1) + "`");
    }
    return found;
  }

  std::optional<Diagnostic> open_bracket() const {
    const bool flow = report_.message.find("flow") != std::string_view::npos;
    const auto open = open_at(source_.text().size());
    if (open && (open->mark == '[' || open->mark == '{')) {
      const SourceSpan span = source_.span(open->offset, 1);
      const std::string close = open->mark == '[' ? "]" : "}";
      Diagnostic found = at(span.line, span.column - 1, 1,
                            "`" + std::string(1, open->mark) + "` is not closed", "it begins here");
      const std::string replacement = std::string(trimmed_end(span.line_text)) + close;
      if (helps(span.line, replacement)) {
        found.fix.push_back("write `" + replacement.substr(span.column - 1) + "`");
      } else {
        found.why.push_back("a `" + close + "` must follow before the next key");
      }
      return found;
    }
    if (!flow || report_.offset >= source_.text().size()) return std::nullopt;
    const char c = source_.text()[report_.offset];
    if (c != ']' && c != '}') return std::nullopt;
    if (const auto other = open_at(report_.offset)) {
      const SourceSpan begin = source_.span(other->offset, 1);
      return at(
          place_.line, place_.column - 1, 1,
          "`" + std::string(1, c) + "` does not close what is open here",
          "`" + std::string(1, other->mark) + "` was opened in line " + std::to_string(begin.line));
    }
    return at(place_.line, place_.column - 1, 1, "`" + std::string(1, c) + "` closes nothing",
              c == ']' ? "no `[` is open here" : "no `{` is open here");
  }

  std::optional<Diagnostic> no_space_after_colon() const {
    for (std::size_t line = line_; line >= 1 && line + 2 > line_; --line) {
      const std::string_view text = source_.line_text(line);
      const std::size_t start = content_start(text);
      std::size_t end = start;
      while (end < text.size() &&
             (std::isalnum(static_cast<unsigned char>(text[end])) != 0 || text[end] == '_'))
        ++end;
      if (end == start || end + 1 >= text.size() || text[end] != ':' || text[end + 1] == ' ')
        continue;
      std::string replacement(text);
      replacement.insert(end + 1, " ");
      if (!helps(line, replacement)) continue;
      Diagnostic found =
          at(line, end, 1, "a space is missing behind a colon", "`key: value` needs the space");
      found.fix.push_back("write `" + replacement.substr(start) + "`");
      return found;
    }
    return std::nullopt;
  }

  /// `key: value` on the line of the error, where quotes around the value help.
  std::optional<Diagnostic> value_needs_quotes() const {
    const std::size_t start = value_start(text_);
    if (start == std::string_view::npos || text_[start] == '[' || text_[start] == '{')
      return std::nullopt;
    std::string_view value = trimmed_end(text_.substr(start));
    const std::string_view whole = value;
    if (value.size() >= 2 && (value.front() == '"' || value.front() == '\'') &&
        value.back() == value.front()) {
      value = value.substr(1, value.size() - 2);
    }
    const std::string quoted =
        value.find('\\') != std::string_view::npos && value.find('\'') == std::string_view::npos
            ? "'" + std::string(value) + "'"
            : "\"" + json_inside(value) + "\"";
    const std::string replacement = std::string(text_.substr(0, start)) + quoted;
    if (quoted == whole || !helps(line_, replacement)) return std::nullopt;
    std::string message = "this value must be in quotes";
    std::string label;
    if (report_.message.find("escape") != std::string_view::npos) {
      message = "a backslash in double quotes begins an escape, and this one does not exist";
    } else if (whole.size() != value.size()) {
      message = "text follows a closing quote";
      label = "a quote ends inside of this";
    } else if (value.find(": ") != std::string_view::npos || value.ends_with(':')) {
      label = "`: ` inside a value would begin another key";
    } else if (std::string_view("@`%|>&*!").find(value.front()) != std::string_view::npos) {
      label = "no plain value begins with `" + std::string(1, value.front()) + "`";
    }
    Diagnostic found = at(line_, start, whole.size(), message, label);
    found.fix.push_back("write `" + replacement.substr(content_start(replacement)) + "`");
    return found;
  }

  /// A word anywhere else (an item of a list), where quotes around it help.
  std::optional<Diagnostic> word_needs_quotes() const {
    const std::string_view line = source_.line_text(place_.line);
    std::size_t start = std::min<std::size_t>(place_.column - 1, line.size());
    while (start > 0 && std::string_view(" [{,").find(line[start - 1]) == std::string_view::npos)
      --start;
    const std::size_t end = std::min(line.find_first_of(",]}", start), line.size());
    const std::string word(trimmed_end(line.substr(start, end - start)));
    if (word.empty() || std::string_view("@`%|>&*!").find(word.front()) == std::string_view::npos)
      return std::nullopt;
    const std::string quoted = "\"" + json_inside(word) + "\"";
    std::string replacement(line);
    replacement.replace(start, word.size(), quoted);
    if (!helps(place_.line, replacement)) return std::nullopt;
    Diagnostic found = at(place_.line, start, word.size(), "this value must be in quotes",
                          "no plain value begins with `" + word.substr(0, 1) + "`");
    found.fix.push_back("write `" + quoted + "`");
    return found;
  }

  static std::string json_inside(std::string_view text) {
    std::string out;
    for (const char c : text) {
      if (c == '"' || c == '\\') out += '\\';
      out += c;
    }
    return out;
  }

  std::optional<Diagnostic> list_behind_key() const {
    const std::size_t start = value_start(text_);
    if (start == std::string_view::npos || !text_.substr(start).starts_with("- "))
      return std::nullopt;
    const std::string key(
        trimmed_end(text_.substr(content_start(text_), start - content_start(text_))));
    const std::string item(trimmed_end(text_.substr(start)));
    Diagnostic found = at(line_, start, 1, "a list cannot begin on the line of its key",
                          "`-` begins a line of its own");
    const std::string indent(content_start(text_), ' ');
    const std::string replacement =
        std::string(text_.substr(0, content_start(text_))) + key + "\n" + indent + "  " + item;
    if (helps(line_, replacement)) found.fix.push_back(key + "\n  " + item);
    return found;
  }

  std::optional<Diagnostic> odd_indentation() const {
    if (place_.column == 0 || content_start(text_) + 1 < place_.column) {
      // The library stopped inside the line: only a line that is too deep stops there (at its
      // colon).
      if (report_.message != "illegal map value") return std::nullopt;
    }
    const std::size_t mine = indent_of(text_);
    std::set<std::size_t> above;
    std::size_t near_above = 0;
    for (std::size_t line = line_; line-- > 1 && above.size() < 8;) {
      const std::string_view text = source_.line_text(line);
      if (is_blank_or_comment(text)) continue;
      if (above.empty()) near_above = line;
      above.insert(indent_of(text));
      above.insert(content_start(text));
      if (indent_of(text) == 0) break;
    }
    std::vector<std::size_t> candidates(above.begin(), above.end());
    const auto distance = [mine](std::size_t indent) {
      return indent > mine ? indent - mine : mine - indent;
    };
    std::stable_sort(candidates.begin(), candidates.end(),
                     [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
    for (const std::size_t candidate : candidates) {
      const std::string replacement = std::string(candidate, ' ') + std::string(text_.substr(mine));
      if (candidate == mine || !helps(line_, replacement)) continue;
      Diagnostic found = at(line_, mine, trimmed_end(text_).size() - mine,
                            "this line is not indented like those above",
                            mine == 0 ? "not indented" : "indented by " + spaces(mine));
      if (near_above > 0) {
        const std::string_view text = source_.line_text(near_above);
        found.why.push_back("line " + std::to_string(near_above) +
                            (indent_of(text) == 0 ? " is not indented"
                                                  : " is indented by " + spaces(indent_of(text))) +
                            "; keys of one mapping and items of one list begin in the same column");
      }
      found.fix.push_back(
          candidate == 0 ? "write line " + std::to_string(line_) + " without the spaces before it"
                         : "indent line " + std::to_string(line_) + " by " + spaces(candidate));
      return found;
    }
    return std::nullopt;
  }

  Diagnostic plain() const {
    const std::string_view line = source_.line_text(place_.line);
    const std::size_t column = place_.column - 1;
    Diagnostic found = at(place_.line, column,
                          trimmed_end(line).size() > column ? trimmed_end(line).size() - column : 1,
                          "this is not YAML", "does not fit the line before it");
    if (text_.substr(indent_of(text_)).starts_with("- ") && report_.message.starts_with("end of")) {
      found.message = "a list item is where a key must be";
      found.why.push_back("a list belongs under a key, such as `launch:`");
    } else if (report_.message == "illegal key without value") {
      found.message = "a key has no `:` after it";
      found.label = "`key: value` is missing its colon";
    } else {
      found.why.push_back("the YAML reader says: " + std::string(report_.message));
    }
    return found;
  }

  const SourceText& source_;
  const YamlSyntaxReport& report_;
  const FirstYamlError& first_error_;
  SourceSpan place_;
  std::size_t line_ = 1;
  std::string_view text_;
};

}  // namespace

Diagnostic yaml_syntax_error(const SourceText& source, const YamlSyntaxReport& report,
                             const FirstYamlError& first_error) {
  return Hint(source, report, first_error).diagnose();
}

}  // namespace ros2wasm
