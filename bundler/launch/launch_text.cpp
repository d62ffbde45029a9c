// See launch_text.hpp.
#include "bundler/launch/launch_text.hpp"

#include <cstddef>
#include <optional>
#include <utility>

namespace ros2wasm {
namespace {

constexpr int kDeepest = 50;

class Parser {
 public:
  Parser(std::string_view text, const SourceSpan& span) : text_(text), span_(span) {}

  std::optional<LaunchText> whole() {
    LaunchText result;
    std::string plain;
    while (at_ < text_.size()) {
      if (!piece(result, plain)) return std::nullopt;
    }
    flush(plain, result);
    return result;
  }

  [[nodiscard]] Diagnostic error() const { return error_; }

 private:
  static void flush(std::string& plain, LaunchText& into) {
    if (!plain.empty()) into.emplace_back(std::move(plain));
    plain.clear();
  }

  /// One character, or one substitution.
  bool piece(LaunchText& into, std::string& plain) {
    if (text_.substr(at_).starts_with("$(")) {
      flush(plain, into);
      auto called = call();
      if (!called) return false;
      into.emplace_back(std::move(*called));
      return true;
    }
    if (text_[at_] == '\\' && at_ + 1 < text_.size()) ++at_;
    plain += text_[at_++];
    return true;
  }

  std::optional<LaunchCall> call() {
    const std::size_t begin = at_;
    if (++depth_ > kDeepest) return fail("substitutions stand too deep in each other");
    at_ += 2;
    skip_space();
    LaunchCall result;
    while (at_ < text_.size() && is_name(text_[at_])) result.name += text_[at_++];
    if (result.name.empty()) return fail("a substitution begins with its name, as in `$(var x)`");
    for (;;) {
      const bool spaced = skip_space();
      if (at_ == text_.size())
        return fail("`" + std::string(text_.substr(begin, 40)) + "` is not closed by `)`");
      if (text_[at_] == ')') break;
      if (!spaced) return fail("`" + result.name + "` and its argument need a space between them");
      auto one = argument();
      if (!one) return std::nullopt;
      result.arguments.push_back(std::move(*one));
    }
    ++at_;
    --depth_;
    return result;
  }

  std::optional<LaunchText> argument() {
    LaunchText result;
    std::string plain;
    const char quote = text_[at_] == '\'' || text_[at_] == '"' ? text_[at_] : '\0';
    if (quote != '\0') ++at_;
    for (;;) {
      if (at_ == text_.size()) {
        if (quote != '\0') return fail(std::string("the quote ") + quote + " is not closed");
        break;
      }
      const char c = text_[at_];
      if (quote != '\0' ? c == quote : c == ')' || is_space(c)) break;
      if (!piece(result, plain)) return std::nullopt;
    }
    if (quote != '\0') ++at_;
    flush(plain, result);
    return result;
  }

  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
  static bool is_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  }
  bool skip_space() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
    return at_ != begin;
  }

  std::nullopt_t fail(std::string message) {
    error_ = {.code = "R2W0411", .message = std::move(message), .span = span_};
    return std::nullopt;
  }

  std::string_view text_;
  const SourceSpan& span_;
  std::size_t at_ = 0;
  int depth_ = 0;
  Diagnostic error_;
};

}  // namespace

Outcome<LaunchText> parse_launch_text(std::string_view text, const SourceSpan& span) {
  Parser parser(text, span);
  auto result = parser.whole();
  if (!result) return parser.error();
  return std::move(*result);
}

}  // namespace ros2wasm
