// See python_format.hpp.
#include "bundler/launch/python/python_format.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "bundler/launch/python/python_function_table.hpp"
#include "bundler/launch/python/python_functions.hpp"

namespace ros2wasm {
namespace {

constexpr int kWidest = 1000;
/// `[[fill]align][sign][#][0][width][,][.precision][type]`, of both kinds of formats.
struct Format {
  std::string fill = " ";
  char align = 0;
  char sign = '-';
  bool grouped = false;
  bool alternate = false;
  int width = 0;
  std::optional<int> precision;
  char type = 0;
};

std::string digits_of(double value, char type, int precision) {
  const auto format = type == 'f'   ? std::chars_format::fixed
                      : type == 'e' ? std::chars_format::scientific
                                    : std::chars_format::general;
  std::array<char, 1500> buffer{};
  const auto [end, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, precision);
  if (error != std::errc()) python_fault("ValueError: too many digits");
  return {buffer.data(), end};
}

std::string grouped(std::string digits) {
  const std::size_t point = std::min(digits.find('.'), digits.size());
  for (std::size_t at = point; at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

/// Without its sign.
std::string of_real(double value, const Format& format) {
  const char type = static_cast<char>(std::tolower(format.type));
  std::string result;
  if (std::isnan(value) || std::isinf(value)) {
    result = std::isnan(value) ? "nan" : "inf";
  } else if (type == 0 && !format.precision) {
    result = python_text({value});
  } else if (type == '%') {
    result = digits_of(value * 100, 'f', format.precision.value_or(6)) + "%";
  } else {
    const int precision = format.precision.value_or(6);
    result = digits_of(value, type == 0 ? 'g' : type,
                       type == 'f' || type == 'e' ? precision : std::max(1, precision));
    if (type == 0 && result.find_first_of(".e") == std::string::npos) result += ".0";
  }
  if (format.type == 'E' || format.type == 'F' || format.type == 'G')
    std::transform(result.begin(), result.end(), result.begin(), ::toupper);
  return result;
}

std::string of_integer(std::uint64_t value, const Format& format) {
  const char type = static_cast<char>(std::tolower(format.type));
  const int base = type == 'x' ? 16 : type == 'o' ? 8 : type == 'b' ? 2 : 10;
  std::array<char, 70> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, base).ptr;
  std::string result(buffer.data(), end);
  if (format.alternate && base != 10) result = std::string("0") + type + result;
  if (format.type == 'X') std::transform(result.begin(), result.end(), result.begin(), ::toupper);
  return result;
}

std::size_t length(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

/// `align` is < > ^ or =, which fills between sign and digits.
std::string aligned(const std::string& sign, const std::string& body, const Format& format,
                    char align) {
  const std::size_t size = length(sign) + length(body);
  const auto width = static_cast<std::size_t>(format.width);
  if (size >= width) return sign + body;
  const auto fill = [&](std::size_t times) {
    std::string result;
    for (std::size_t i = 0; i < times; ++i) result += format.fill;
    return result;
  };
  const std::size_t rest = width - size;
  if (align == '<') return sign + body + fill(rest);
  if (align == '=') return sign + fill(rest) + body;
  if (align == '^') return fill(rest / 2) + sign + body + fill(rest - rest / 2);
  return fill(rest) + sign + body;
}

std::string number_text(const PythonValue& value, const Format& format) {
  const bool real_type =
      std::string_view("eEfFgG%").find(format.type) != std::string_view::npos && format.type != 0;
  const auto whole = python_integer(value);
  std::string body;
  bool negative = false;
  if (whole && !real_type) {
    negative = *whole < 0;
    body = of_integer(
        negative ? 0 - static_cast<std::uint64_t>(*whole) : static_cast<std::uint64_t>(*whole),
        format);
  } else {
    const double real = python_real(value);
    if (!real_type && format.type != 0)
      python_fault(std::string("ValueError: Unknown format code '") + format.type +
                   "' for object of type 'float'");
    negative = std::signbit(real) && !std::isnan(real);
    body = of_real(std::fabs(real), format);
  }
  if (format.grouped) body = grouped(body);
  const std::string sign = negative ? "-" : format.sign == '-' ? "" : std::string(1, format.sign);
  return aligned(sign, body, format, format.align == 0 ? '>' : format.align);
}

std::string plain_text(std::string text, const Format& format, char align) {
  if (format.precision) {
    std::string cut;
    int left = *format.precision;
    for (const char c : text) {
      const bool begins = (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
      if (begins && left-- == 0) break;
      cut += c;
    }
    text = cut;
  }
  return aligned("", text, format, format.align == 0 ? align : format.align);
}

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  [[nodiscard]] bool done() const { return at_ == text_.size(); }
  [[nodiscard]] char peek(std::size_t further = 0) const {
    return at_ + further < text_.size() ? text_[at_ + further] : '\0';
  }
  char next() {
    if (done()) python_fault("ValueError: incomplete format");
    return text_[at_++];
  }
  bool take(char wanted) {
    if (peek() != wanted || done()) return false;
    ++at_;
    return true;
  }
  std::optional<int> number() {
    std::optional<int> result;
    while (std::isdigit(static_cast<unsigned char>(peek())) != 0) {
      result = result.value_or(0) * 10 + (next() - '0');
      if (*result > kWidest) python_fault("ValueError: the width or precision is too large");
    }
    return result;
  }
  /// Up to `mark`, which is taken too.
  std::string until(char mark) {
    std::string result;
    for (char c = next(); c != mark; c = next()) result += c;
    return result;
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

Format format_of(std::string_view spec) {
  Reader reader(spec);
  Format result;
  const auto aligns = [](char c) { return c == '<' || c == '>' || c == '^' || c == '='; };
  if (aligns(reader.peek(1))) {
    result.fill = std::string(1, reader.next());
    result.align = reader.next();
  } else if (aligns(reader.peek())) {
    result.align = reader.next();
  }
  if (reader.peek() == '+' || reader.peek() == ' ' || reader.peek() == '-')
    result.sign = reader.next();
  result.alternate = reader.take('#');
  if (reader.take('0') && result.align == 0) {
    result.fill = "0";
    result.align = '=';
  }
  result.width = reader.number().value_or(0);
  result.grouped = reader.take(',');
  if (reader.take('.')) {
    result.precision = reader.number();
    if (!result.precision) python_fault("ValueError: Format specifier missing precision");
  }
  if (!reader.done()) result.type = reader.next();
  if (!reader.done()) python_fault("ValueError: Invalid format specifier");
  return result;
}

std::string formatted_value(const PythonValue& value, std::string_view spec) {
  if (spec.empty()) return python_text(value);
  const Format format = format_of(spec);
  const bool number = python_number(value).has_value() && !std::holds_alternative<bool>(value.held);
  if (number && format.type != 's') return number_text(value, format);
  if (format.type != 0 && format.type != 's')
    python_fault(std::string("ValueError: Unknown format code '") + format.type +
                 "' for object of type '" + std::string(python_type(value)) + "'");
  return plain_text(python_text(value), format, '<');
}

/// `name`, `0`, `0.key`, `0[key]`.
PythonValue field_value(const std::string& field, const PythonArguments& arguments,
                        std::size_t& counter) {
  const std::size_t end = std::min(field.find_first_of(".["), field.size());
  const std::string name = field.substr(0, end);
  PythonValue value{PythonNone{}};
  if (name.empty() || name.find_first_not_of("0123456789") == std::string::npos) {
    const std::size_t at =
        name.empty() ? counter++ : static_cast<std::size_t>(Reader(name).number().value_or(0));
    if (at >= arguments.values.size())
      python_fault("IndexError: Replacement index " + std::to_string(at) +
                   " out of range for positional args tuple");
    value = arguments.values[at];
  } else {
    const PythonValue* named = python_named(arguments, name);
    if (named == nullptr) python_fault("KeyError: '" + name + "'");
    value = *named;
  }
  Reader rest(std::string_view(field).substr(end));
  while (!rest.done()) {
    if (!rest.take('[')) python_fault("ValueError: attributes are not read in formats here");
    const std::string key = rest.until(']');
    const bool number = key.find_first_not_of("0123456789") == std::string::npos;
    value = python_item(value, number ? python_to_integer({key}) : PythonValue{key});
  }
  return value;
}

std::string percent_one(Reader& reader, const PythonList& all, std::size_t& counter,
                        const PythonValue& whole) {
  std::optional<PythonValue> value;
  if (reader.take('(')) value = python_item(whole, {reader.until(')')});
  Format format;
  bool zeros = false;
  for (bool flag = true; flag;) {
    const char c = reader.peek();
    if (c == '-') format.align = '<';
    if (c == '+' || (c == ' ' && format.sign != '+')) format.sign = c;
    format.alternate |= c == '#';
    zeros |= c == '0';
    flag = c == '-' || c == '+' || c == ' ' || c == '#' || c == '0';
    if (flag) reader.next();
  }
  if (zeros && format.align == 0) {
    format.fill = "0";
    format.align = '=';
  }
  format.width = reader.number().value_or(0);
  if (reader.take('.')) format.precision = reader.number().value_or(0);
  format.type = reader.next();
  if (format.type == '%') return "%";
  if (!value) {
    if (counter >= all.size()) python_fault("TypeError: not enough arguments for format string");
    value = all[counter++];
  }
  if (format.type == 's' || format.type == 'r') {
    if (format.align == '=') {
      format.align = '>';
      format.fill = " ";
    }
    return plain_text(python_text(*value, format.type == 'r'), format, '>');
  }
  if (std::string_view("diueEfFgGxXo").find(format.type) == std::string_view::npos)
    python_fault(std::string("ValueError: unsupported format character '") + format.type + "'");
  if (!python_number(*value))
    python_fault(std::string("TypeError: %") + format.type +
                 " format: a real number is required, not " + std::string(python_type(*value)));
  if (format.type == 'd' || format.type == 'i' || format.type == 'u') {
    format.type = 'd';
    value = python_to_integer(*value);
  }
  return number_text(*value, format);
}

void check_length(const std::string& text) {
  if (text.size() > kPythonLongest) python_fault("MemoryError: the text is too long");
}

}  // namespace

std::string python_percent(std::string_view format, const PythonValue& values) {
  const auto* tuple = std::get_if<PythonTuple>(&values.held);
  const PythonList all = tuple != nullptr ? tuple->items : PythonList{values};
  Reader reader(format);
  std::string result;
  std::size_t counter = 0;
  while (!reader.done()) {
    const char c = reader.next();
    result += c == '%' ? percent_one(reader, all, counter, values) : std::string(1, c);
    check_length(result);
  }
  // One list or dictionary may go unused, as names could have asked for its parts.
  if (counter < all.size() && python_type(values) != "dict" && python_type(values) != "list")
    python_fault("TypeError: not all arguments converted during string formatting");
  return result;
}

std::string python_formatted(std::string_view format, const PythonArguments& arguments) {
  Reader reader(format);
  std::string result;
  std::size_t counter = 0;
  while (!reader.done()) {
    const char c = reader.next();
    const bool brace = c == '{' || c == '}';
    if (!brace || reader.take(c)) {
      result += c;
    } else if (c == '}') {
      python_fault("ValueError: Single '}' encountered in format string");
    } else {
      const std::string all = reader.until('}');
      const std::size_t colon = std::min(all.find(':'), all.size());
      std::string field = all.substr(0, colon);
      const bool quoted = field.ends_with("!r");
      if (quoted || field.ends_with("!s")) field.resize(field.size() - 2);
      PythonValue value = field_value(field, arguments, counter);
      if (quoted) value = {python_text(value, true)};
      result += formatted_value(
          value, colon < all.size() ? std::string_view(all).substr(colon + 1) : std::string_view());
    }
    check_length(result);
  }
  return result;
}

}  // namespace ros2wasm
