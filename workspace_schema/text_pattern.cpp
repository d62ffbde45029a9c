// See text_pattern.hpp. The regular expressions are the C library's.
#include "workspace_schema/text_pattern.hpp"

#include <regex.h>

#include <optional>
#include <variant>

namespace ros2wasm {
namespace {

constexpr std::size_t kLongestRegex = 256;

Diagnostic bad_pattern(std::string_view text, const std::string& why) {
  return Diagnostic{
      .code = "R2W0303",
      .message = "the pattern `" + std::string(text.substr(0, 100)) + "` cannot be used: " + why};
}

/// The expression in POSIX's words, or why it has none.
std::variant<std::string, Diagnostic> posix_form(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char next = i + 1 < text.size() ? text[i + 1] : '\0';
    if (text[i] == '{') return bad_pattern(text, "counts like `{2}` are not supported");
    if (text[i] == '(' && next == '?') {
      if (text.substr(i).starts_with("(?:")) {
        out += '(';
        i += 2;
        continue;
      }
      return bad_pattern(text, "look-around and flags are not supported");
    }
    if (text[i] != '\\') {
      out += text[i];
      continue;
    }
    ++i;
    switch (next) {
      case 'd':
        out += "[0-9]";
        break;
      case 'w':
        out += "[A-Za-z0-9_]";
        break;
      case 's':
        out += "[[:space:]]";
        break;
      default:
        if ((next >= '0' && next <= '9') || (next >= 'a' && next <= 'z') ||
            (next >= 'A' && next <= 'Z') || next == '\0') {
          return bad_pattern(text, std::string("`\\") + next + "` is not supported");
        }
        out += '\\';
        out += next;
    }
  }
  return out;
}

}  // namespace

struct TextPattern::Regex {
  regex_t compiled{};
  Regex() = default;
  ~Regex() { regfree(&compiled); }
  Regex(const Regex&) = delete;
  Regex& operator=(const Regex&) = delete;
};

std::string ascii_lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return out;
}

bool glob_matches(std::string_view pattern, std::string_view value) {
  std::size_t p = 0;
  std::size_t v = 0;
  std::optional<std::size_t> star;  // where the last `*` stands, and up to where it has eaten
  std::size_t eaten = 0;
  while (v < value.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      eaten = v;
    } else if (p < pattern.size() && pattern[p] == value[v]) {
      ++p;
      ++v;
    } else if (star) {
      p = *star + 1;
      v = ++eaten;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

Outcome<TextPattern> TextPattern::parse(std::string_view text, LetterCase letter_case) {
  TextPattern pattern;
  pattern.letter_case_ = letter_case;
  pattern.text_ = letter_case == LetterCase::kIgnored ? ascii_lower(text) : std::string(text);
  if (text.size() >= 2 && text.front() == '^' && text.back() == '$') {
    if (text.size() > kLongestRegex) return bad_pattern(text, "it is too long");
    const auto posix = posix_form(pattern.text_);
    if (const auto* fault = std::get_if<Diagnostic>(&posix)) return *fault;
    auto regex = std::make_shared<Regex>();
    if (regcomp(&regex->compiled, std::get<std::string>(posix).c_str(), REG_EXTENDED | REG_NOSUB) !=
        0) {
      return bad_pattern(text, "it is no regular expression");
    }
    pattern.kind_ = Kind::kRegex;
    pattern.regex_ = std::move(regex);
  } else if (text.find('*') != std::string_view::npos) {
    pattern.kind_ = Kind::kGlob;
  }
  return pattern;
}

bool TextPattern::matches(std::string_view value) const {
  const std::string folded =
      letter_case_ == LetterCase::kIgnored ? ascii_lower(value) : std::string(value);
  switch (kind_) {
    case Kind::kExact:
      return folded == text_;
    case Kind::kGlob:
      return glob_matches(text_, folded);
    case Kind::kRegex:
      return regexec(&regex_->compiled, folded.c_str(), 0, nullptr, 0) == 0;
  }
  return false;
}

}  // namespace ros2wasm
