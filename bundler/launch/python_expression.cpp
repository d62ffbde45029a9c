// See python_expression.hpp. First the text becomes a tree, then the tree a value: what stands
// behind a decided `or` or in the other branch of an `if` is read but never evaluated.
#include "bundler/launch/python_expression.hpp"

#include <cctype>
#include <charconv>
#include <utility>

#include "bundler/launch/python_value.hpp"

namespace ros2wasm {
namespace {

constexpr int kDeepest = 100;
/// `1+1+...` makes a tree as deep as it is long.
constexpr std::size_t kLongest = 4096;

enum class Form {
  kValue,
  kName,
  kList,
  kChoice,  ///< value, condition, other value
  kOr,
  kAnd,
  kNot,
  kComparison,  ///< operand, then pairs of the operator (a kName) and an operand
  kArithmetic,
  kNegated,
  kItem,
  kCall,
  kMethod,  ///< the object, then the arguments
};

struct Expression {
  Form form = Form::kValue;
  std::string text;  ///< a name or an operator
  PythonValue value{PythonNone{}};
  std::vector<Expression> parts;
};

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  Expression whole() {
    Expression result = choice();
    if (skip(); at_ != text_.size()) syntax();
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
  static bool in_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
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
    if (!word("else")) syntax();
    Expression other = choice();
    return made(Form::kChoice, {}, of(std::move(value), std::move(condition), std::move(other)));
  }

  Expression disjunction() {
    Expression left = conjunction();
    while (word("or")) left = made(Form::kOr, {}, of(std::move(left), conjunction()));
    return left;
  }

  Expression conjunction() {
    Expression left = negation();
    while (word("and")) left = made(Form::kAnd, {}, of(std::move(left), negation()));
    return left;
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
    Expression left = sum();
    std::vector<Expression> parts;
    for (std::string op = comparator(); !op.empty(); op = comparator()) {
      if (parts.empty()) parts.push_back(std::move(left));
      parts.push_back(made(Form::kName, std::move(op), {}));
      parts.push_back(sum());
    }
    return parts.empty() ? left : made(Form::kComparison, {}, std::move(parts));
  }

  Expression sum() {
    Expression left = product();
    for (;;) {
      const std::string op = symbol("+") ? "+" : symbol("-") ? "-" : "";
      if (op.empty()) return left;
      left = made(Form::kArithmetic, op, of(std::move(left), product()));
    }
  }

  Expression product() {
    Expression left = factor();
    for (;;) {
      const std::string op = symbol("//") ? "//" : symbol("/") ? "/" : symbol("%") ? "%" : times();
      if (op.empty()) return left;
      left = made(Form::kArithmetic, op, of(std::move(left), factor()));
    }
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
    return made(Form::kArithmetic, "**", of(std::move(base), factor()));
  }

  Expression postfix() {
    Expression value = atom();
    for (;;) {
      if (symbol("[")) {
        value = made(Form::kItem, {}, of(std::move(value), choice()));
        need("]");
      } else if (symbol(".")) {
        std::string method = name();
        need("(");
        std::vector<Expression> parts;
        parts.push_back(std::move(value));
        items_until(")", parts);
        value = made(Form::kMethod, std::move(method), std::move(parts));
      } else {
        return value;
      }
    }
  }

  /// True when a comma stood among them.
  bool items_until(std::string_view close, std::vector<Expression>& into) {
    bool comma = false;
    while (!symbol(close)) {
      into.push_back(choice());
      if (symbol(close)) break;
      need(",");
      comma = true;
    }
    return comma;
  }

  std::string name() {
    skip();
    std::string result;
    while (at_ < text_.size() && in_word(text_[at_])) result += text_[at_++];
    if (result.empty()) syntax();
    return result;
  }

  Expression atom() {
    skip();
    if (at_ == text_.size()) syntax();
    const char c = text_[at_];
    std::vector<Expression> parts;
    if (symbol("(")) {
      const bool tuple = items_until(")", parts);
      if (parts.size() == 1 && !tuple) return std::move(parts.front());
      return made(Form::kList, {}, std::move(parts));
    }
    if (symbol("[")) {
      items_until("]", parts);
      return made(Form::kList, {}, std::move(parts));
    }
    if (c == '\'' || c == '"') return text();
    if (std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.') return number();
    if (!in_word(c)) syntax();
    std::string called = name();
    if (called == "math" && symbol(".")) called = "math." + name();
    if (!symbol("(")) return made(Form::kName, std::move(called), {});
    items_until(")", parts);
    return made(Form::kCall, std::move(called), std::move(parts));
  }

  /// Texts beside each other are one.
  Expression text() {
    std::string result;
    while (at_ < text_.size() && (text_[at_] == '\'' || text_[at_] == '"')) {
      const char quote = text_[at_++];
      for (; at_ < text_.size() && text_[at_] != quote; ++at_) {
        if (text_[at_] == '\\' && at_ + 1 < text_.size()) {
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

  Expression number() {
    const char* begin = text_.data() + at_;
    const char* end = text_.data() + text_.size();
    std::int64_t whole = 0;
    const auto integer = std::from_chars(begin, end, whole);
    double real = 0;
    const auto decimal = std::from_chars(begin, end, real);
    if (decimal.ec != std::errc()) syntax();
    const bool is_whole = integer.ec == std::errc() && integer.ptr == decimal.ptr;
    at_ = static_cast<std::size_t>(decimal.ptr - text_.data());
    if (at_ < text_.size() && in_word(text_[at_])) syntax();
    return {.value = is_whole ? PythonValue{whole} : PythonValue{real}};
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

PythonValue value_of(const Expression& expression);

PythonList values_of(const std::vector<Expression>& parts, std::size_t from) {
  PythonList result;
  for (std::size_t i = from; i < parts.size(); ++i) result.push_back(value_of(parts[i]));
  return result;
}

PythonValue named(const std::string& name) {
  PythonValue value{PythonNone{}};
  if (!python_name(name, value)) throw PythonFault{"NameError: name '" + name + "' is not defined"};
  return value;
}

PythonValue compared(const std::vector<Expression>& parts) {
  PythonValue left = value_of(parts[0]);
  for (std::size_t i = 1; i < parts.size(); i += 2) {
    PythonValue right = value_of(parts[i + 1]);
    const std::string& op = parts[i].text;
    const bool holds =
        op == "not in" ? !python_compare("in", left, right) : python_compare(op, left, right);
    if (!holds) return {false};
    left = std::move(right);
  }
  return {true};
}

PythonValue value_of(const Expression& expression) {
  const auto& [form, text, value, parts] = expression;
  switch (form) {
    case Form::kValue:
      return value;
    case Form::kName:
      return named(text);
    case Form::kList:
      return {values_of(parts, 0)};
    case Form::kChoice:
      return value_of(truth(value_of(parts[1])) ? parts[0] : parts[2]);
    case Form::kOr: {
      PythonValue left = value_of(parts[0]);
      return truth(left) ? left : value_of(parts[1]);
    }
    case Form::kAnd: {
      PythonValue left = value_of(parts[0]);
      return truth(left) ? value_of(parts[1]) : left;
    }
    case Form::kNot:
      return {!truth(value_of(parts[0]))};
    case Form::kComparison:
      return compared(parts);
    case Form::kArithmetic:
      return python_arithmetic(text, value_of(parts[0]), value_of(parts[1]));
    case Form::kNegated:
      return python_negated(value_of(parts[0]));
    case Form::kItem:
      return python_item(value_of(parts[0]), value_of(parts[1]));
    case Form::kCall:
      return python_call(text, values_of(parts, 0));
    case Form::kMethod:
      return python_method(value_of(parts[0]), text, values_of(parts, 1));
  }
  return {PythonNone{}};
}

}  // namespace

Outcome<std::string> evaluate_python(std::string_view expression, const SourceSpan& span) {
  try {
    if (expression.size() > kLongest)
      throw PythonFault{"it is longer than " + std::to_string(kLongest) + " bytes"};
    return python_text(value_of(Parser(expression).whole()));
  } catch (const PythonFault& fault) {
    return Diagnostic{.code = "R2W0411",
                      .message = "`$(eval ...)` cannot be evaluated: " + fault.message,
                      .span = span,
                      .why = {"the expression is: " + std::string(expression.substr(0, 200))}};
  }
}

}  // namespace ros2wasm
