// See python_parser.hpp. One function per precedence, the loosest first.
#include "bundler/launch/python/python_parser.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <utility>

namespace ros2wasm {
namespace {

constexpr int kDeepest = 100;
constexpr std::size_t kLongest = 4096;

constexpr std::array<std::string_view, 35> kKeywords{
    "False", "None",     "True",  "and",    "as",   "assert", "async",  "await",    "break",
    "class", "continue", "def",   "del",    "elif", "else",   "except", "finally",  "for",
    "from",  "global",   "if",    "import", "in",   "is",     "lambda", "nonlocal", "not",
    "or",    "pass",     "raise", "return", "try",  "while",  "with",   "yield"};

bool in_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

using Form = PythonForm;
using Expression = PythonExpression;

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  Expression whole() {
    Expression result = choice();
    if (symbol(",")) {
      std::vector<Expression> parts = of(std::move(result));
      while (!at_end()) {
        parts.push_back(choice());
        if (!symbol(",")) break;
      }
      result = made(Form::kTuple, {}, std::move(parts));
    }
    if (!at_end()) syntax();
    return result;
  }

 private:
  /// Counts how deep the text nests, so that no text can exhaust the stack.
  class Level {
   public:
    explicit Level(int& depth) : depth_(depth) {
      if (++depth_ > kDeepest) throw PythonFault{"RecursionError: the expression is too deep"};
    }
    ~Level() { --depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    int& depth_;
  };

  [[noreturn]] void syntax() const {
    const std::string rest(text_.substr(at_, 20));
    throw PythonFault{"SyntaxError: invalid syntax " +
                      (rest.empty() ? std::string("at the end") : "at `" + rest + "`")};
  }

  void skip() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  bool at_end() {
    skip();
    return at_ == text_.size();
  }
  [[nodiscard]] char ahead(std::size_t further) const {
    return at_ + further < text_.size() ? text_[at_ + further] : '\0';
  }
  bool symbol(std::string_view wanted) {
    skip();
    if (!text_.substr(at_).starts_with(wanted)) return false;
    at_ += wanted.size();
    return true;
  }
  bool word(std::string_view wanted) {
    skip();
    const std::size_t end = at_ + wanted.size();
    if (!text_.substr(at_).starts_with(wanted) || (end < text_.size() && in_word(text_[end])))
      return false;
    at_ = end;
    return true;
  }
  void need(std::string_view wanted) {
    if (!symbol(wanted)) syntax();
  }
  void need_word(std::string_view wanted) {
    if (!word(wanted)) syntax();
  }

  static Expression made(Form form, std::string text, std::vector<Expression> parts) {
    return {.form = form, .text = std::move(text), .parts = std::move(parts)};
  }

  /// Moved, where braces would copy the whole tree so far.
  template <typename... Parts>
  static std::vector<Expression> of(Parts... parts) {
    std::vector<Expression> result;
    (result.push_back(std::move(parts)), ...);
    return result;
  }

  Expression choice() {
    const Level level(depth_);
    Expression value = disjunction();
    if (!word("if")) return value;
    Expression condition = disjunction();
    need_word("else");
    Expression other = choice();
    return made(Form::kChoice, {}, of(std::move(value), std::move(condition), std::move(other)));
  }

  Expression disjunction() {
    std::vector<Expression> parts = of(conjunction());
    while (word("or")) parts.push_back(conjunction());
    return parts.size() == 1 ? std::move(parts[0]) : made(Form::kOr, {}, std::move(parts));
  }

  Expression conjunction() {
    std::vector<Expression> parts = of(negation());
    while (word("and")) parts.push_back(negation());
    return parts.size() == 1 ? std::move(parts[0]) : made(Form::kAnd, {}, std::move(parts));
  }

  Expression negation() {
    const Level level(depth_);
    if (word("not")) return made(Form::kNot, {}, of(negation()));
    return comparison();
  }

  std::string comparator() {
    for (const char* op : {"==", "!=", "<=", ">=", "<", ">"})
      if (symbol(op)) return op;
    if (word("in")) return "in";
    const std::size_t begin = at_;
    if (word("not")) {
      if (word("in")) return "not in";
      at_ = begin;
    }
    if (word("is")) return word("not") ? "!=" : "==";
    return {};
  }

  Expression comparison() {
    std::vector<Expression> parts = of(sum());
    for (std::string op = comparator(); !op.empty(); op = comparator()) {
      parts.push_back(made(Form::kName, std::move(op), {}));
      parts.push_back(sum());
    }
    return parts.size() == 1 ? std::move(parts[0]) : made(Form::kComparison, {}, std::move(parts));
  }

  Expression sum() {
    std::vector<Expression> parts = of(product());
    for (;;) {
      const std::string op = symbol("+") ? "+" : symbol("-") ? "-" : "";
      if (op.empty()) return chain(std::move(parts));
      parts.push_back(made(Form::kName, op, {}));
      parts.push_back(product());
    }
  }

  Expression product() {
    std::vector<Expression> parts = of(factor());
    for (;;) {
      const std::string op = symbol("//") ? "//" : symbol("/") ? "/" : symbol("%") ? "%" : times();
      if (op.empty()) return chain(std::move(parts));
      parts.push_back(made(Form::kName, op, {}));
      parts.push_back(factor());
    }
  }
  static Expression chain(std::vector<Expression> parts) {
    return parts.size() == 1 ? std::move(parts[0]) : made(Form::kArithmetic, {}, std::move(parts));
  }
  std::string times() {
    skip();
    return !text_.substr(at_).starts_with("**") && symbol("*") ? "*" : "";
  }

  Expression factor() {
    const Level level(depth_);
    if (symbol("-")) return made(Form::kNegated, {}, of(factor()));
    if (symbol("+")) return factor();
    Expression base = postfix();
    if (!symbol("**")) return base;
    return chain(of(std::move(base), made(Form::kName, "**", {}), factor()));
  }

  Expression postfix() {
    Expression value = atom();
    for (int links = 0;; ++links) {
      if (links > kDeepest) throw PythonFault{"RecursionError: the expression is too deep"};
      if (symbol("[")) {
        value = item(std::move(value));
      } else if (symbol("(")) {
        value = call(Form::kCall, {}, std::move(value));
      } else if (symbol(".")) {
        std::string attribute = name();
        value = symbol("(") ? call(Form::kMethod, std::move(attribute), std::move(value))
                            : made(Form::kAttribute, std::move(attribute), of(std::move(value)));
      } else {
        return value;
      }
    }
  }

  Expression item(Expression value) {
    std::vector<Expression> parts = of(std::move(value));
    const auto part = [&] {
      parts.push_back(ahead_is(":") || ahead_is("]") ? Expression{} : choice());
    };
    if (ahead_is("]")) syntax();
    part();
    if (symbol("]")) return made(Form::kItem, {}, std::move(parts));
    need(":");
    part();
    if (symbol(":")) part();
    parts.resize(4);
    need("]");
    return made(Form::kSlice, {}, std::move(parts));
  }
  bool ahead_is(std::string_view wanted) {
    skip();
    return text_.substr(at_).starts_with(wanted);
  }

  /// From behind the `(`. `name=value` comes last.
  Expression call(Form form, std::string called, Expression value) {
    Expression result = made(form, std::move(called), of(std::move(value)));
    while (!symbol(")")) {
      if (const auto keyword = argument_name(); !keyword.empty()) {
        result.names.push_back(keyword);
      } else if (!result.names.empty()) {
        syntax();
      }
      Expression argument = choice();
      if (word("for")) argument = comprehension(std::move(argument));
      result.parts.push_back(std::move(argument));
      if (symbol(")")) break;
      need(",");
    }
    return result;
  }

  /// The name before a `=`, which is taken too; nothing when there is none.
  std::string argument_name() {
    skip();
    std::size_t end = at_;
    while (end < text_.size() && in_word(text_[end])) ++end;
    std::string result(text_.substr(at_, end - at_));
    while (end < text_.size() && text_[end] == ' ') ++end;
    const bool assigns = end < text_.size() && text_[end] == '=' &&
                         (end + 1 == text_.size() || text_[end + 1] != '=');
    if (!assigns || !is_python_name(result)) return {};
    at_ = end + 1;
    return result;
  }

  /// True when a comma stood among them. With `for` behind the first, it is a comprehension.
  bool items_until(std::string_view close, std::vector<Expression>& into, bool& loops) {
    bool comma = false;
    while (!symbol(close)) {
      into.push_back(choice());
      if (into.size() == 1 && word("for")) {
        into.front() = comprehension(std::move(into.front()));
        need(close);
        loops = true;
        return false;
      }
      if (symbol(close)) break;
      need(",");
      comma = true;
    }
    return comma;
  }

  /// From behind the `for`.
  Expression comprehension(Expression element) {
    return made(Form::kComprehension, {}, of(loop(std::move(element))));
  }
  Expression loop(Expression element) {
    const Level level(depth_);
    Expression result = made(Form::kFor, {}, {});
    const bool closed = symbol("(");
    do {
      result.names.push_back(name());
    } while (symbol(","));
    if (closed) need(")");
    need_word("in");
    result.parts.push_back(disjunction());
    result.parts.emplace_back();
    while (word("if")) result.parts.push_back(disjunction());
    result.parts[1] = word("for") ? loop(std::move(element)) : std::move(element);
    return result;
  }

  std::string name() {
    skip();
    std::string result;
    while (at_ < text_.size() && in_word(text_[at_])) result += text_[at_++];
    if (!is_python_name(result)) syntax();
    return result;
  }

  Expression atom() {
    if (at_end()) syntax();
    const char c = text_[at_];
    std::vector<Expression> parts;
    bool loops = false;
    if (symbol("(")) {
      const bool tuple = items_until(")", parts, loops);
      if (parts.size() == 1 && !tuple) return std::move(parts.front());
      return made(Form::kTuple, {}, std::move(parts));
    }
    if (symbol("[")) {
      items_until("]", parts, loops);
      if (loops) return std::move(parts.front());
      return made(Form::kList, {}, std::move(parts));
    }
    if (symbol("{")) return dictionary();
    if (c == '\'' || c == '"') return text(false);
    if ((c == 'u' || c == 'r') && (ahead(1) == '\'' || ahead(1) == '"')) {
      ++at_;
      return text(c == 'r');
    }
    if (std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.') return number();
    if (!in_word(c)) syntax();
    for (const char* constant : {"True", "False", "None"})
      if (word(constant)) return made(Form::kName, constant, {});
    return made(Form::kName, name(), {});
  }

  Expression dictionary() {
    std::vector<Expression> parts;
    while (!symbol("}")) {
      parts.push_back(choice());
      need(":");
      parts.push_back(choice());
      if (symbol("}")) break;
      need(",");
    }
    return made(Form::kDict, {}, std::move(parts));
  }

  /// Texts beside each other are one.
  Expression text(bool raw) {
    std::string result;
    while (at_ < text_.size() && (text_[at_] == '\'' || text_[at_] == '"')) {
      const char quote = text_[at_++];
      for (; at_ < text_.size() && text_[at_] != quote; ++at_) {
        if (text_[at_] == '\\' && !raw && at_ + 1 < text_.size()) {
          const char escaped = text_[++at_];
          result += escaped == 'n' ? '\n' : escaped == 't' ? '\t' : escaped;
        } else {
          result += text_[at_];
        }
      }
      if (at_ == text_.size()) throw PythonFault{"SyntaxError: unterminated string literal"};
      ++at_;
      skip();
    }
    return {.value = {std::move(result)}};
  }

  /// Digits, with `_` between them.
  std::string digits(bool hexadecimal) {
    const auto is_digit = [hexadecimal](char c) {
      const auto one = static_cast<unsigned char>(c);
      return (hexadecimal ? std::isxdigit(one) : std::isdigit(one)) != 0;
    };
    std::string result;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '_' && !result.empty() && is_digit(ahead(1))) continue;
      if (!is_digit(c)) break;
      result += c;
    }
    return result;
  }

  /// `200and x` is a number and a keyword: launch files that join texts have such.
  [[nodiscard]] bool begins_keyword() const {
    const std::string_view rest = text_.substr(at_);
    const std::string_view keywords[] = {"and", "else", "for", "if", "in", "is", "not", "or"};
    return std::any_of(std::begin(keywords), std::end(keywords),
                       [&](std::string_view one) { return rest.starts_with(one); });
  }

  Expression number() {
    const bool hexadecimal = ahead(0) == '0' && (ahead(1) == 'x' || ahead(1) == 'X');
    if (hexadecimal) at_ += 2;
    std::string written = digits(hexadecimal);
    if (!hexadecimal && ahead(0) == '.') {
      written += text_[at_++];
      written += digits(false);
    }
    const bool exponent = !hexadecimal && (ahead(0) == 'e' || ahead(0) == 'E');
    const std::size_t sign = ahead(1) == '+' || ahead(1) == '-' ? 2 : 1;
    if (exponent && std::isdigit(static_cast<unsigned char>(ahead(sign))) != 0) {
      written += text_.substr(at_, sign);
      at_ += sign;
      written += digits(false);
    }
    const char* begin = written.data();
    const char* end = begin + written.size();
    if (in_word(ahead(0)) && !begins_keyword()) syntax();
    std::int64_t whole = 0;
    const auto integer = std::from_chars(begin, end, whole, hexadecimal ? 16 : 10);
    if (integer.ec == std::errc() && integer.ptr == end) return {.value = {whole}};
    double real = 0;
    const auto decimal = std::from_chars(begin, end, real);
    if (hexadecimal || decimal.ec != std::errc() || decimal.ptr != end) syntax();
    return {.value = {real}};
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

PythonExpression parse_python(std::string_view expression) {
  if (expression.size() > kLongest)
    throw PythonFault{"it is longer than " + std::to_string(kLongest) + " bytes"};
  return Parser(expression).whole();
}

bool is_python_name(std::string_view text) {
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) == 0 &&
         std::all_of(text.begin(), text.end(), in_word) &&
         std::find(kKeywords.begin(), kKeywords.end(), text) == kKeywords.end();
}

}  // namespace ros2wasm
