// See text_pattern.hpp. The regular expressions are the C library's.
#include "workspace_schema/base/text_pattern.hpp"

#include <regex.h>

#include <algorithm>
#include <bitset>
#include <optional>

namespace ros2wasm {
namespace {

constexpr std::size_t kLongestRegex = 256;

Diagnostic bad_pattern(std::string_view text, const std::string& why) {
  return Diagnostic{
      .code = "R2W0303",
      .message = "the pattern `" + std::string(text.substr(0, 100)) + "` cannot be used: " + why};
}

using Characters = std::bitset<128>;

/// Writes a Python expression in POSIX's words. What cannot be said, and what Python refuses, ends
/// with a reason.
class PosixForm {
 public:
  explicit PosixForm(std::string_view text) : text_(text) {}

  Outcome<std::string> write() {
    while (at_ < text_.size()) {
      if (const char* why = piece()) return bad_pattern(text_, why);
    }
    if (depth_ != 0) return bad_pattern(text_, "a parenthesis is not closed");
    // Python matches from the beginning, whatever the alternatives say.
    return "^(" + out_ + ")";
  }

 private:
  [[nodiscard]] char peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }

  /// One character, class, group sign or repetition; nothing, or what is wrong.
  const char* piece() {
    const char c = peek();
    switch (c) {
      case '[':
        return bracket();
      case '\\':
        return escape();
      case '{':
      case '*':
      case '+':
      case '?':
        return repetition(c);
      case '(':
        if (peek(1) == '?' && peek(2) != ':') return "look-around and flags are not supported";
        at_ += peek(1) == '?' ? 3 : 1;
        ++depth_;
        break;
      case ')':
        if (depth_-- == 0) return "a parenthesis is not opened";
        out_ += c;
        ++at_;
        repeatable_ = true;
        return nullptr;
      default:
        out_ += c;
        ++at_;
        repeatable_ = c != '|' && c != '^' && c != '$';
        return nullptr;
    }
    out_ += '(';
    repeatable_ = false;
    return nullptr;
  }

  const char* repetition(char c) {
    if (!repeatable_) return "there is nothing to repeat";
    if (c == '{') {
      if (const char* why = count()) return why;
    } else {
      out_ += c;
      ++at_;
    }
    if (peek() == '+') return "possessive repetition is not supported";
    if (peek() == '?') ++at_;  // the same texts match, whether it is greedy or not
    repeatable_ = false;
    return nullptr;
  }

  /// `{2}`, `{2,}`, `{2,3}`. Each count multiplies the compiled size, so their product is bounded.
  const char* count() {
    constexpr std::size_t kLargestProduct = 1024;
    const std::size_t end = text_.find('}', at_);
    const std::string_view inside =
        text_.substr(at_ + 1, end == std::string_view::npos ? 0 : end - at_ - 1);
    const std::size_t comma = inside.find(',');
    const auto first = small_number(inside.substr(0, comma));
    const auto last = comma == std::string_view::npos || comma + 1 == inside.size()
                          ? first
                          : small_number(inside.substr(comma + 1));
    if (!first || !last || *last < *first) return "such a count in `{}` is not supported";
    product_ *= std::max<std::size_t>(*last, 1);
    if (product_ > kLargestProduct) return "it repeats too often";
    out_ += '{';
    out_ += inside;
    out_ += '}';
    at_ = end + 1;
    return nullptr;
  }

  static std::optional<std::size_t> small_number(std::string_view digits) {
    if (digits.empty() || digits.size() > 3) return std::nullopt;
    std::size_t number = 0;
    for (const char c : digits) {
      if (c < '0' || c > '9') return std::nullopt;
      number = number * 10 + static_cast<std::size_t>(c - '0');
    }
    return number;
  }

  static void add(Characters& set, char from, char to) {
    const unsigned last = static_cast<unsigned char>(to);
    for (unsigned c = static_cast<unsigned char>(from); c <= last; ++c) set.set(c);
  }

  /// Adds what `\c` stands for; false when it is not supported.
  static bool add_escaped(Characters& set, char c) {
    if (c == 'd' || c == 'w') {
      add(set, '0', '9');
      if (c == 'w') {
        add(set, 'a', 'z');
        add(set, 'A', 'Z');
        set.set('_');
      }
    } else if (c == 's') {
      add(set, '\t', '\r');
      set.set(' ');
    } else if ((c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
               c <= ' ') {
      return false;
    } else {
      set.set(static_cast<std::size_t>(c));
    }
    return true;
  }

  const char* escape() {
    Characters set;
    if (!add_escaped(set, peek(1))) return "this `\\` is not supported";
    at_ += 2;
    put(set, false);
    return nullptr;
  }

  const char* bracket() {
    Characters set;
    ++at_;
    const bool negated = peek() == '^';
    if (negated) ++at_;
    for (bool first = true; first || peek() != ']'; first = false) {
      const char c = peek();
      if (c < ' ') return "a bracket is not closed, or holds a character that is not supported";
      if (c == '\\') {
        if (!add_escaped(set, peek(1))) return "this `\\` is not supported";
        at_ += 2;
      } else if (peek(1) == '-' && peek(2) > ' ' && peek(2) != ']' && peek(2) != '\\') {
        if (peek(2) < c) return "a range in a bracket goes backwards";
        add(set, c, peek(2));
        at_ += 3;
      } else {
        set.set(static_cast<std::size_t>(c));
        ++at_;
      }
    }
    ++at_;
    put(set, negated);
    return nullptr;
  }

  /// As a bracket of POSIX, where the places of `]`, `[`, `^` and `-` matter and `\` means itself.
  void put(Characters set, bool negated) {
    constexpr std::string_view kLast = "[^-";
    repeatable_ = true;
    if (!negated && set.test('^') && (set.count() == 1 || (set.count() == 2 && set.test('-')))) {
      out_ += set.count() == 1 ? "\\^" : "[-^]";
      return;
    }
    out_ += negated ? "[^" : "[";
    if (set.test(']')) out_ += ']';
    for (std::size_t c = 1; c < set.size(); ++c) {
      const bool placed = c == ']' || kLast.find(static_cast<char>(c)) != std::string_view::npos;
      if (set.test(c) && !placed) out_ += static_cast<char>(c);
    }
    for (const char c : kLast) {
      if (set.test(static_cast<std::size_t>(c))) out_ += c;
    }
    out_ += ']';
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::string out_;
  int depth_ = 0;
  bool repeatable_ = false;
  std::size_t product_ = 1;
};

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
    auto posix = PosixForm(pattern.text_).write();
    if (!posix) return std::move(posix).errors();
    auto regex = std::make_shared<Regex>();
    if (regcomp(&regex->compiled, posix->c_str(), REG_EXTENDED | REG_NOSUB) != 0) {
      return bad_pattern(text, "it is not a regular expression");
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

std::string hex_text(std::string_view bytes) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string text(2 * bytes.size(), '\0');
  char* digit = text.data();  // one lookup of the text's place, not two for each byte
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    *digit++ = kHex[byte >> 4U];
    *digit++ = kHex[byte & 0xFU];
  }
  return text;
}

}  // namespace ros2wasm
