// See python_value.hpp.
#include "bundler/launch/python_value.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

namespace ros2wasm {
namespace {

constexpr std::size_t kLongest = 1U << 20U;

[[noreturn]] void fault(std::string message) {
  throw PythonFault{std::move(message)};
}

template <typename T>
const T* as(const PythonValue& value) {
  return std::get_if<T>(&value.held);
}

/// Booleans count as 0 and 1.
std::optional<std::int64_t> integer(const PythonValue& value) {
  if (const bool* one = as<bool>(value)) return *one ? 1 : 0;
  if (const auto* one = as<std::int64_t>(value)) return *one;
  return std::nullopt;
}

std::optional<double> number(const PythonValue& value) {
  if (const auto whole = integer(value)) return static_cast<double>(*whole);
  if (const double* one = as<double>(value)) return *one;
  return std::nullopt;
}

double needed_number(const PythonValue& value) {
  const auto one = number(value);
  if (!one) fault("TypeError: must be real number, not " + std::string(python_type(value)));
  return *one;
}

/// As Python's repr(): the shortest digits that read back, an exponent from 1e16 on and below 1e-4.
std::string float_text(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  const double size = std::fabs(value);
  const bool scientific = value != 0 && (size >= 1e16 || size < 1e-4);
  std::array<char, 64> buffer{};
  const auto format = scientific ? std::chars_format::scientific : std::chars_format::fixed;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format).ptr;
  std::string text(buffer.data(), end);
  if (!scientific && text.find('.') == std::string::npos) text += ".0";
  return text;
}

std::string quoted_text(const std::string& text) {
  const char quote =
      text.find('\'') != std::string::npos && text.find('"') == std::string::npos ? '"' : '\'';
  std::string result(1, quote);
  for (const char c : text) {
    if (c == quote || c == '\\') {
      result += {'\\', c};
    } else if (c == '\n') {
      result += "\\n";
    } else {
      result += c;
    }
  }
  return result + quote;
}

[[noreturn]] void unsupported(std::string_view op, const PythonValue& a, const PythonValue& b) {
  fault("TypeError: unsupported operand type(s) for " + std::string(op) + ": '" +
        std::string(python_type(a)) + "' and '" + std::string(python_type(b)) + "'");
}

std::int64_t floor_divided(std::int64_t a, std::int64_t b) {
  if (b == 0) fault("ZeroDivisionError: integer division or modulo by zero");
  if (b == -1) return -a;
  const std::int64_t quotient = a / b;
  return a % b != 0 && (a < 0) != (b < 0) ? quotient - 1 : quotient;
}

/// Whole numbers are of 64 bits here; Python's have no end.
std::int64_t checked(std::string_view op, std::int64_t a, std::int64_t b) {
  std::int64_t result = 0;
  const bool over = op == "+"   ? __builtin_add_overflow(a, b, &result)
                    : op == "-" ? __builtin_sub_overflow(a, b, &result)
                                : __builtin_mul_overflow(a, b, &result);
  if (over) fault("OverflowError: the result is larger than 64 bits");
  return result;
}

PythonValue whole_power(std::int64_t base, std::int64_t exponent) {
  if (exponent < 0) return {std::pow(static_cast<double>(base), static_cast<double>(exponent))};
  std::int64_t result = 1;
  for (std::int64_t i = 0; i < exponent; ++i) {
    if (base == 0 || base == 1) return {base};
    if (base == -1) return {exponent % 2 == 0 ? std::int64_t{1} : std::int64_t{-1}};
    result = checked("*", result, base);
  }
  return {result};
}

PythonValue of_integers(std::string_view op, std::int64_t a, std::int64_t b) {
  if (op == "//") return {floor_divided(a, b)};
  if (op == "%") return {b == -1 ? 0 : a - floor_divided(a, b) * b};
  if (op == "**") return whole_power(a, b);
  if (op == "/") {
    if (b == 0) fault("ZeroDivisionError: division by zero");
    return {static_cast<double>(a) / static_cast<double>(b)};
  }
  return {checked(op, a, b)};
}

PythonValue of_numbers(std::string_view op, double a, double b) {
  if (op == "+") return {a + b};
  if (op == "-") return {a - b};
  if (op == "*") return {a * b};
  if (op == "**") return {std::pow(a, b)};
  if (b == 0) fault("ZeroDivisionError: float division by zero");
  if (op == "/") return {a / b};
  if (op == "//") return {std::floor(a / b)};
  const double rest = std::fmod(a, b);
  return {rest != 0 && (rest < 0) != (b < 0) ? rest + b : rest};
}

template <typename T>
PythonValue repeated(const T& one, std::int64_t times) {
  T result;
  if (times > 0 && one.size() * static_cast<std::uint64_t>(times) > kLongest)
    fault("MemoryError: the result is too long");
  for (std::int64_t i = 0; i < times; ++i) result.insert(result.end(), one.begin(), one.end());
  return {result};
}

std::string changed_case(std::string text, int (*change)(int)) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x80) c = static_cast<char>(change(c));
  return text;
}

std::string stripped(const std::string& text, const std::string& marks, bool left, bool right) {
  std::size_t begin = left ? text.find_first_not_of(marks) : 0;
  if (begin == std::string::npos || text.empty()) return {};
  const std::size_t last = right ? text.find_last_not_of(marks) : text.size() - 1;
  return last == std::string::npos ? std::string() : text.substr(begin, last - begin + 1);
}

PythonList split(const std::string& text, const std::optional<std::string>& by) {
  PythonList result;
  if (!by) {
    std::string word;
    for (const char c : text + " ") {
      const bool space = c == ' ' || (c >= '\t' && c <= '\r');
      if (!space) {
        word += c;
      } else if (!word.empty()) {
        result.push_back({std::exchange(word, {})});
      }
    }
    return result;
  }
  if (by->empty()) fault("ValueError: empty separator");
  std::size_t begin = 0;
  for (std::size_t at = text.find(*by); at != std::string::npos; at = text.find(*by, begin)) {
    result.push_back({text.substr(begin, at - begin)});
    begin = at + by->size();
  }
  result.push_back({text.substr(begin)});
  return result;
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  if (what.empty()) fault("ValueError: empty text to replace");
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + with.size())) {
    text.replace(at, what.size(), with);
    if (text.size() > kLongest) fault("MemoryError: the result is too long");
  }
  return text;
}

const std::string& text_argument(const PythonList& arguments, std::size_t i) {
  const std::string* text = i < arguments.size() ? as<std::string>(arguments[i]) : nullptr;
  if (text == nullptr) fault("TypeError: a str is needed as argument " + std::to_string(i + 1));
  return *text;
}

PythonValue to_integer(const PythonValue& value) {
  if (const auto whole = integer(value)) return {*whole};
  if (const double* real = as<double>(value)) {
    if (!(std::fabs(*real) < 9.2e18)) fault("OverflowError: cannot convert float to integer");
    return {static_cast<std::int64_t>(*real)};
  }
  if (const std::string* text = as<std::string>(value)) {
    const std::string digits = stripped(*text, " \t\n\r", true, true);
    const std::size_t skip = digits.starts_with('+') ? 1 : 0;
    std::int64_t result = 0;
    const auto [end, error] =
        std::from_chars(digits.data() + skip, digits.data() + digits.size(), result);
    if (error == std::errc() && end == digits.data() + digits.size()) return {result};
    fault("ValueError: invalid literal for int() with base 10: " + quoted_text(*text));
  }
  fault("TypeError: int() argument must be a string or a real number, not '" +
        std::string(python_type(value)) + "'");
}

PythonValue to_float(const PythonValue& value) {
  if (const auto real = number(value)) return {*real};
  if (const std::string* text = as<std::string>(value)) {
    const std::string digits = stripped(*text, " \t\n\r", true, true);
    const std::size_t skip = digits.starts_with('+') ? 1 : 0;
    double result = 0;
    const auto [end, error] =
        std::from_chars(digits.data() + skip, digits.data() + digits.size(), result);
    if (error == std::errc() && end == digits.data() + digits.size()) return {result};
    fault("ValueError: could not convert string to float: " + quoted_text(*text));
  }
  fault("TypeError: float() argument must be a string or a real number, not '" +
        std::string(python_type(value)) + "'");
}

PythonValue extreme(std::string_view op, const PythonList& arguments) {
  const PythonList* list = arguments.size() == 1 ? as<PythonList>(arguments[0]) : nullptr;
  const PythonList& among = list != nullptr ? *list : arguments;
  if (among.empty()) fault("ValueError: nothing to choose from");
  const PythonValue* best = &among.front();
  for (const PythonValue& one : among)
    if (python_compare(op, one, *best)) best = &one;
  return *best;
}

/// To the even neighbour in the middle, as Python rounds.
PythonValue rounded(const PythonList& arguments) {
  const double value = needed_number(arguments[0]);
  if (arguments.size() == 1) return to_integer({std::nearbyint(value)});
  // Through decimal digits, which round the exact value.
  const auto digits = integer(arguments[1]);
  if (!digits || *digits < 0 || *digits > 300)
    fault("ValueError: round() takes 0 to 300 digits here");
  std::array<char, 700> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::fixed, static_cast<int>(*digits))
                       .ptr;
  double result = value;
  std::from_chars(buffer.data(), end, result);
  return {result};
}

PythonValue length_of(const PythonValue& value) {
  if (const auto* list = as<PythonList>(value)) return {static_cast<std::int64_t>(list->size())};
  if (const auto* text = as<std::string>(value)) {
    const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
    return {static_cast<std::int64_t>(std::count_if(text->begin(), text->end(), begins))};
  }
  fault("TypeError: object of type '" + std::string(python_type(value)) + "' has no len()");
}

PythonValue summed(const PythonValue& list) {
  const auto* items = as<PythonList>(list);
  if (items == nullptr) fault("TypeError: sum() takes a list");
  PythonValue result{std::int64_t{0}};
  for (const PythonValue& one : *items) result = python_arithmetic("+", result, one);
  return result;
}

using Function = std::function<PythonValue(const PythonList&)>;
struct FunctionRow {
  std::size_t least;
  std::size_t most;
  Function call;
};

FunctionRow real(double (*function)(double)) {
  return {1, 1, [function](const PythonList& a) {
            const double result = function(needed_number(a[0]));
            if (std::isnan(result) && !std::isnan(needed_number(a[0])))
              fault("ValueError: math domain error");
            return PythonValue{result};
          }};
}

FunctionRow whole(double (*function)(double)) {
  return {1, 1,
          [function](const PythonList& a) { return to_integer({function(needed_number(a[0]))}); }};
}

const std::map<std::string, FunctionRow, std::less<>>& functions() {
  static const std::map<std::string, FunctionRow, std::less<>> table{
      {"abs",
       {1, 1,
        [](const PythonList& a) {
          return python_compare("<", a[0], {std::int64_t{0}}) ? python_negated(a[0]) : a[0];
        }}},
      {"all",
       {1, 1,
        [](const PythonList& a) {
          const auto* list = as<PythonList>(a[0]);
          return PythonValue{list != nullptr && std::all_of(list->begin(), list->end(), truth)};
        }}},
      {"any",
       {1, 1,
        [](const PythonList& a) {
          const auto* list = as<PythonList>(a[0]);
          return PythonValue{list != nullptr && std::any_of(list->begin(), list->end(), truth)};
        }}},
      {"bool", {1, 1, [](const PythonList& a) { return PythonValue{truth(a[0])}; }}},
      {"float", {1, 1, [](const PythonList& a) { return to_float(a[0]); }}},
      {"int", {1, 1, [](const PythonList& a) { return to_integer(a[0]); }}},
      {"len", {1, 1, [](const PythonList& a) { return length_of(a[0]); }}},
      {"max", {1, 99, [](const PythonList& a) { return extreme(">", a); }}},
      {"min", {1, 99, [](const PythonList& a) { return extreme("<", a); }}},
      {"round", {1, 2, rounded}},
      {"str", {1, 1, [](const PythonList& a) { return PythonValue{python_text(a[0])}; }}},
      {"sum", {1, 1, [](const PythonList& a) { return summed(a[0]); }}},
      {"acos", real(std::acos)},
      {"asin", real(std::asin)},
      {"atan", real(std::atan)},
      {"atan2",
       {2, 2,
        [](const PythonList& a) {
          return PythonValue{std::atan2(needed_number(a[0]), needed_number(a[1]))};
        }}},
      {"ceil", whole(std::ceil)},
      {"cos", real(std::cos)},
      {"degrees",
       {1, 1,
        [](const PythonList& a) {
          return PythonValue{needed_number(a[0]) * (180.0 / std::numbers::pi)};
        }}},
      {"exp", real(std::exp)},
      {"fabs", real(std::fabs)},
      {"floor", whole(std::floor)},
      {"hypot",
       {2, 2,
        [](const PythonList& a) {
          return PythonValue{std::hypot(needed_number(a[0]), needed_number(a[1]))};
        }}},
      {"log",
       {1, 2,
        [](const PythonList& a) {
          if (needed_number(a[0]) <= 0) fault("ValueError: math domain error");
          const double natural = std::log(needed_number(a[0]));
          return PythonValue{a.size() == 1 ? natural : natural / std::log(needed_number(a[1]))};
        }}},
      {"log10", real(std::log10)},
      {"log2", real(std::log2)},
      {"pow",
       {2, 2,
        [](const PythonList& a) {
          return PythonValue{std::pow(needed_number(a[0]), needed_number(a[1]))};
        }}},
      {"radians",
       {1, 1,
        [](const PythonList& a) {
          return PythonValue{needed_number(a[0]) * (std::numbers::pi / 180.0)};
        }}},
      {"sin", real(std::sin)},
      {"sqrt", real(std::sqrt)},
      {"tan", real(std::tan)},
      {"trunc", whole(std::trunc)},
  };
  return table;
}

}  // namespace

bool truth(const PythonValue& value) {
  if (as<PythonNone>(value) != nullptr) return false;
  if (const auto real = number(value)) return *real != 0;
  if (const auto* text = as<std::string>(value)) return !text->empty();
  return !std::get<PythonList>(value.held).empty();
}

std::string python_text(const PythonValue& value, bool quoted) {
  if (as<PythonNone>(value) != nullptr) return "None";
  if (const bool* one = as<bool>(value)) return *one ? "True" : "False";
  if (const auto* one = as<std::int64_t>(value)) return std::to_string(*one);
  if (const double* one = as<double>(value)) return float_text(*one);
  if (const auto* one = as<std::string>(value)) return quoted ? quoted_text(*one) : *one;
  std::string result = "[";
  for (const PythonValue& one : std::get<PythonList>(value.held))
    result += (result.size() > 1 ? ", " : "") + python_text(one, true);
  return result + "]";
}

std::string_view python_type(const PythonValue& value) {
  constexpr std::array<std::string_view, 6> names{"NoneType", "bool", "int",
                                                  "float",    "str",  "list"};
  return names[value.held.index()];
}

bool python_equal(const PythonValue& a, const PythonValue& b) {
  const auto whole_a = integer(a);
  const auto whole_b = integer(b);
  if (whole_a && whole_b) return *whole_a == *whole_b;
  const auto real_a = number(a);
  const auto real_b = number(b);
  if (real_a && real_b) return *real_a == *real_b;
  if (a.held.index() != b.held.index()) return false;
  if (const auto* text = as<std::string>(a)) return *text == std::get<std::string>(b.held);
  const auto* list = as<PythonList>(a);
  if (list == nullptr) return true;  // None
  const auto& other = std::get<PythonList>(b.held);
  return std::equal(list->begin(), list->end(), other.begin(), other.end(), python_equal);
}

PythonValue python_arithmetic(std::string_view op, const PythonValue& a, const PythonValue& b) {
  const auto whole_a = integer(a);
  const auto whole_b = integer(b);
  if (whole_a && whole_b) return of_integers(op, *whole_a, *whole_b);
  const auto real_a = number(a);
  const auto real_b = number(b);
  if (real_a && real_b) return of_numbers(op, *real_a, *real_b);
  if (op == "+" && a.held.index() == b.held.index()) {
    if (const auto* text = as<std::string>(a)) return {*text + std::get<std::string>(b.held)};
    if (const auto* list = as<PythonList>(a)) {
      PythonList joined = *list;
      const auto& other = std::get<PythonList>(b.held);
      joined.insert(joined.end(), other.begin(), other.end());
      return {std::move(joined)};
    }
  }
  if (op == "*" && (whole_a || whole_b)) {
    const PythonValue& many = whole_a ? b : a;
    const std::int64_t times = whole_a ? *whole_a : *whole_b;
    if (const auto* text = as<std::string>(many)) return repeated(*text, times);
    if (const auto* list = as<PythonList>(many)) return repeated(*list, times);
  }
  unsupported(op, a, b);
}

bool python_compare(std::string_view op, const PythonValue& a, const PythonValue& b) {
  if (op == "==") return python_equal(a, b);
  if (op == "!=") return !python_equal(a, b);
  if (op == "in") {
    if (const auto* list = as<PythonList>(b)) {
      return std::any_of(list->begin(), list->end(),
                         [&](const PythonValue& one) { return python_equal(a, one); });
    }
    const auto* part = as<std::string>(a);
    const auto* text = as<std::string>(b);
    if (part != nullptr && text != nullptr) return text->find(*part) != std::string::npos;
    fault("TypeError: argument of type '" + std::string(python_type(b)) + "' is not iterable");
  }
  const auto ordered = [&](const auto& x, const auto& y) {
    return op == "<" ? x < y : op == "<=" ? x <= y : op == ">" ? x > y : x >= y;
  };
  const auto whole_a = integer(a);
  const auto whole_b = integer(b);
  if (whole_a && whole_b) return ordered(*whole_a, *whole_b);
  const auto real_a = number(a);
  const auto real_b = number(b);
  if (real_a && real_b) return ordered(*real_a, *real_b);
  const auto* text_a = as<std::string>(a);
  const auto* text_b = as<std::string>(b);
  if (text_a != nullptr && text_b != nullptr) return ordered(*text_a, *text_b);
  fault("TypeError: '" + std::string(op) + "' not supported between instances of '" +
        std::string(python_type(a)) + "' and '" + std::string(python_type(b)) + "'");
}

PythonValue python_negated(const PythonValue& value) {
  if (const auto whole = integer(value)) return {checked("-", 0, *whole)};
  return {-needed_number(value)};
}

PythonValue python_item(const PythonValue& of, const PythonValue& index) {
  const auto at = integer(index);
  if (!at) fault("TypeError: indices must be integers");
  const auto place = [&](std::size_t size) {
    const std::int64_t signed_size = static_cast<std::int64_t>(size);
    const std::int64_t from_start = *at < 0 ? *at + signed_size : *at;
    if (from_start < 0 || from_start >= signed_size) fault("IndexError: index out of range");
    return static_cast<std::size_t>(from_start);
  };
  if (const auto* list = as<PythonList>(of)) return (*list)[place(list->size())];
  if (const auto* text = as<std::string>(of)) return {std::string(1, (*text)[place(text->size())])};
  fault("TypeError: '" + std::string(python_type(of)) + "' object is not subscriptable");
}

PythonValue python_call(std::string_view function, const PythonList& arguments) {
  if (function.starts_with("math.")) function.remove_prefix(5);
  const auto row = functions().find(function);
  if (row == functions().end())
    fault("NameError: name '" + std::string(function) + "' is not defined");
  if (arguments.size() < row->second.least || arguments.size() > row->second.most)
    fault("TypeError: " + std::string(function) + "() got " + std::to_string(arguments.size()) +
          " arguments");
  return row->second.call(arguments);
}

PythonValue python_method(const PythonValue& of, std::string_view method,
                          const PythonList& arguments) {
  if (const auto* list = as<PythonList>(of)) {
    const auto same = [&](const PythonValue& one) { return python_equal(one, arguments[0]); };
    if (method == "count" && arguments.size() == 1)
      return {static_cast<std::int64_t>(std::count_if(list->begin(), list->end(), same))};
  }
  if (const auto* text = as<std::string>(of)) {
    const std::string space = " \t\n\r\v\f";
    const auto* given = arguments.empty() ? nullptr : as<std::string>(arguments[0]);
    const std::string& marks = given != nullptr ? *given : space;
    if (method == "lower") return {changed_case(*text, std::tolower)};
    if (method == "upper") return {changed_case(*text, std::toupper)};
    if (method == "strip") return {stripped(*text, marks, true, true)};
    if (method == "lstrip") return {stripped(*text, marks, true, false)};
    if (method == "rstrip") return {stripped(*text, marks, false, true)};
    if (method == "split")
      return {split(*text, arguments.empty() ? std::nullopt : std::optional(marks))};
    if (method == "startswith") return {text->starts_with(text_argument(arguments, 0))};
    if (method == "endswith") return {text->ends_with(text_argument(arguments, 0))};
    if (method == "find") {
      const std::size_t at = text->find(text_argument(arguments, 0));
      return {at == std::string::npos ? std::int64_t{-1} : static_cast<std::int64_t>(at)};
    }
    if (method == "replace")
      return {replaced(*text, text_argument(arguments, 0), text_argument(arguments, 1))};
    if (method == "isdigit")
      return {!text->empty() && text->find_first_not_of("0123456789") == std::string::npos};
    if (method == "join" && arguments.size() == 1) {
      const auto* list = as<PythonList>(arguments[0]);
      if (list == nullptr) fault("TypeError: can only join a list");
      std::string joined;
      for (std::size_t i = 0; i < list->size(); ++i)
        joined += (i > 0 ? *text : "") + text_argument(*list, i);
      return {joined};
    }
  }
  fault("AttributeError: '" + std::string(python_type(of)) + "' object has no attribute '" +
        std::string(method) + "'");
}

bool python_name(std::string_view name, PythonValue& into) {
  if (name.starts_with("math.")) name.remove_prefix(5);
  if (name == "True") {
    into = {true};
  } else if (name == "False") {
    into = {false};
  } else if (name == "None") {
    into = {PythonNone{}};
  } else if (name == "pi") {
    into = {std::numbers::pi};
  } else if (name == "tau") {
    into = {2 * std::numbers::pi};
  } else if (name == "e") {
    into = {std::numbers::e};
  } else if (name == "inf") {
    into = {std::numeric_limits<double>::infinity()};
  } else if (name == "nan") {
    into = {std::numeric_limits<double>::quiet_NaN()};
  } else {
    return false;
  }
  return true;
}

}  // namespace ros2wasm
