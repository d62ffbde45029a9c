// See python_value.hpp.
#include "bundler/launch/python/python_value.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>

namespace ros2wasm {
namespace {

template <typename T>
const T* as(const PythonValue& value) {
  return std::get_if<T>(&value.held);
}

const PythonDict* as_dict(const PythonValue& value) {
  const auto* held = as<std::shared_ptr<const PythonDict>>(value);
  return held != nullptr ? held->get() : nullptr;
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
    } else if (c == '\n' || c == '\t' || c == '\r') {
      result += {'\\', c == '\n' ? 'n' : c == '\t' ? 't' : 'r'};
    } else {
      result += c;
    }
  }
  return result + quote;
}

std::string listed(const PythonList& items, const std::string& open, const std::string& close) {
  std::string result = open;
  for (const PythonValue& one : items) {
    result += (result.size() > open.size() ? ", " : "") + python_text(one, true);
    if (result.size() > kPythonLongest) python_fault("MemoryError: the text is too long");
  }
  return result + close;
}

std::string listed(const PythonDict& dict) {
  std::string result = "{";
  for (const auto& [key, value] : dict.entries) {
    result +=
        (result.size() > 1 ? ", " : "") + python_text(key, true) + ": " + python_text(value, true);
    if (result.size() > kPythonLongest) python_fault("MemoryError: the text is too long");
  }
  return result + "}";
}

/// The characters, of up to four bytes each.
std::vector<std::string> characters(const std::string& text) {
  std::vector<std::string> result;
  for (const char c : text) {
    if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U || result.empty()) result.emplace_back();
    result.back() += c;
  }
  return result;
}

std::size_t place_of(const PythonValue& index, std::size_t size) {
  const auto at = python_integer(index);
  if (!at) python_fault("TypeError: indices must be integers");
  const auto signed_size = static_cast<std::int64_t>(size);
  const std::int64_t from_start = *at < 0 ? *at + signed_size : *at;
  if (from_start < 0 || from_start >= signed_size) python_fault("IndexError: index out of range");
  return static_cast<std::size_t>(from_start);
}

template <typename T>
T sliced(const T& all, const PythonValue& begin, const PythonValue& end, const PythonValue& step) {
  const auto whole = [](const PythonValue& value, std::int64_t otherwise) {
    if (as<PythonNone>(value) != nullptr) return otherwise;
    const auto one = python_integer(value);
    if (!one) python_fault("TypeError: slice indices must be integers or None");
    return *one;
  };
  const auto size = static_cast<std::int64_t>(all.size());
  const std::int64_t by = whole(step, 1);
  if (by == 0) python_fault("ValueError: slice step cannot be zero");
  const std::int64_t lowest = by > 0 ? 0 : -1;
  const std::int64_t highest = by > 0 ? size : size - 1;
  const auto bound = [&](const PythonValue& value, std::int64_t otherwise) {
    if (as<PythonNone>(value) != nullptr) return otherwise;
    std::int64_t at = whole(value, 0);
    if (at < 0) at = std::max(at, -size - 1) + size;
    return std::clamp(at, lowest, highest);
  };
  const std::int64_t first = bound(begin, by > 0 ? lowest : highest);
  const std::int64_t last = bound(end, by > 0 ? highest : lowest);
  T result;
  const std::int64_t stride = std::clamp(by, -size - 1, size + 1);
  for (std::int64_t i = first; by > 0 ? i < last : i > last; i += stride)
    result.push_back(all[static_cast<std::size_t>(i)]);
  return result;
}

bool ordered_items(std::string_view op, const PythonList& a, const PythonList& b) {
  const auto [at, other] = std::mismatch(a.begin(), a.end(), b.begin(), b.end(), python_equal);
  if (at != a.end() && other != b.end()) return python_compare(op, *at, *other);
  return op == "<"    ? a.size() < b.size()
         : op == "<=" ? a.size() <= b.size()
         : op == ">"  ? a.size() > b.size()
                      : a.size() >= b.size();
}

bool contains(const PythonValue& part, const PythonValue& whole) {
  if (const PythonList* items = python_items(whole)) {
    return std::any_of(items->begin(), items->end(),
                       [&](const PythonValue& one) { return python_equal(part, one); });
  }
  if (const PythonDict* dict = as_dict(whole)) return python_entry(*dict, part) != nullptr;
  if (const auto* text = as<std::string>(whole)) {
    const auto* wanted = as<std::string>(part);
    if (wanted == nullptr)
      python_fault("TypeError: 'in <string>' requires string as left operand, not " +
                   std::string(python_type(part)));
    return python_find(*text, *wanted) != std::string::npos;
  }
  python_fault("TypeError: argument of type '" + std::string(python_type(whole)) +
               "' is not iterable");
}

std::string_view trimmed(const std::string& text) {
  constexpr std::string_view space = " \t\n\r\v\f";
  const std::size_t begin = text.find_first_not_of(space);
  if (begin == std::string::npos) return {};
  return std::string_view(text).substr(begin, text.find_last_not_of(space) - begin + 1);
}

template <typename T>
std::optional<T> read_number(const std::string& text) {
  std::string_view digits = trimmed(text);
  if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
  T result{};
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), result);
  if (error != std::errc() || end != digits.data() + digits.size() || digits.empty())
    return std::nullopt;
  return result;
}

}  // namespace

void python_fault(std::string message) {
  throw PythonFault{std::move(message)};
}

PythonValue python_dict(PythonDict dict) {
  return {std::make_shared<const PythonDict>(std::move(dict))};
}

const PythonValue* python_entry(const PythonDict& dict, const PythonValue& key) {
  for (const auto& [one, value] : dict.entries)
    if (python_equal(one, key)) return &value;
  return nullptr;
}

std::optional<std::int64_t> python_integer(const PythonValue& value) {
  if (const bool* one = as<bool>(value)) return *one ? 1 : 0;
  if (const auto* one = as<std::int64_t>(value)) return *one;
  return std::nullopt;
}

std::optional<double> python_number(const PythonValue& value) {
  if (const auto whole = python_integer(value)) return static_cast<double>(*whole);
  if (const double* one = as<double>(value)) return *one;
  return std::nullopt;
}

const PythonList* python_items(const PythonValue& value) {
  if (const auto* list = as<PythonList>(value)) return list;
  if (const auto* tuple = as<PythonTuple>(value)) return &tuple->items;
  return nullptr;
}

PythonList python_iterated(const PythonValue& value) {
  if (const PythonList* items = python_items(value)) return *items;
  PythonList result;
  if (const PythonDict* dict = as_dict(value)) {
    for (const auto& [key, one] : dict->entries) result.push_back(key);
    return result;
  }
  const auto* text = as<std::string>(value);
  if (text == nullptr)
    python_fault("TypeError: '" + std::string(python_type(value)) + "' object is not iterable");
  for (std::string& one : characters(*text)) result.push_back({std::move(one)});
  return result;
}

bool python_nests_deeper(const PythonValue& value, int levels) {
  const auto deeper = [levels](const PythonValue& one) {
    return python_nests_deeper(one, levels - 1);
  };
  const PythonDict* dict = as_dict(value);
  const PythonList* items = python_items(value);
  if (dict == nullptr && items == nullptr) return false;
  if (levels == 0) return true;
  if (items != nullptr) return std::any_of(items->begin(), items->end(), deeper);
  return std::any_of(dict->entries.begin(), dict->entries.end(), [&](const auto& entry) {
    return deeper(entry.first) || deeper(entry.second);
  });
}

bool truth(const PythonValue& value) {
  if (as<PythonNone>(value) != nullptr) return false;
  if (const auto real = python_number(value)) return *real != 0;
  if (const auto* text = as<std::string>(value)) return !text->empty();
  if (const PythonList* items = python_items(value)) return !items->empty();
  if (const PythonDict* dict = as_dict(value)) return !dict->entries.empty();
  return true;
}

std::string python_text(const PythonValue& value, bool quoted) {
  if (as<PythonNone>(value) != nullptr) return "None";
  if (const bool* one = as<bool>(value)) return *one ? "True" : "False";
  if (const auto* one = as<std::int64_t>(value)) return std::to_string(*one);
  if (const double* one = as<double>(value)) return float_text(*one);
  if (const auto* one = as<std::string>(value)) return quoted ? quoted_text(*one) : *one;
  if (const auto* list = as<PythonList>(value)) return listed(*list, "[", "]");
  if (const auto* tuple = as<PythonTuple>(value))
    return listed(tuple->items, "(", tuple->items.size() == 1 ? ",)" : ")");
  if (const PythonDict* dict = as_dict(value)) return listed(*dict);
  if (const auto* function = as<std::shared_ptr<const PythonFunction>>(value))
    return "<function " + (*function)->name + ">";
  return "<namespace " + std::get<std::shared_ptr<const PythonNamespace>>(value.held)->name + ">";
}

std::string_view python_type(const PythonValue& value) {
  constexpr std::array<std::string_view, 10> names{
      "NoneType", "bool", "int", "float", "str", "list", "tuple", "dict", "function", "namespace"};
  return names[value.held.index()];
}

bool python_equal(const PythonValue& a, const PythonValue& b) {
  const auto whole_a = python_integer(a);
  const auto whole_b = python_integer(b);
  if (whole_a && whole_b) return *whole_a == *whole_b;
  const auto real_a = python_number(a);
  const auto real_b = python_number(b);
  if (real_a && real_b) return *real_a == *real_b;
  if (a.held.index() != b.held.index()) return false;
  if (const auto* text = as<std::string>(a)) return *text == std::get<std::string>(b.held);
  if (as<PythonNone>(a) != nullptr) return true;
  if (const PythonList* items = python_items(a)) {
    const PythonList& others = *python_items(b);
    return std::equal(items->begin(), items->end(), others.begin(), others.end(), python_equal);
  }
  if (const PythonDict* dict = as_dict(a)) {
    const PythonDict& other = *as_dict(b);
    return dict->entries.size() == other.entries.size() &&
           std::all_of(dict->entries.begin(), dict->entries.end(), [&](const auto& entry) {
             const PythonValue* match = python_entry(other, entry.first);
             return match != nullptr && python_equal(entry.second, *match);
           });
  }
  if (const auto* function = as<std::shared_ptr<const PythonFunction>>(a))
    return *function == std::get<std::shared_ptr<const PythonFunction>>(b.held);
  using Namespace = std::shared_ptr<const PythonNamespace>;
  return std::get<Namespace>(a.held) == std::get<Namespace>(b.held);
}

std::size_t python_find(std::string_view text, std::string_view part, std::size_t from) {
  if (from > text.size()) return std::string_view::npos;
  // The C libraries of Linux and of Emscripten search in linear time here.
  const void* found = memmem(text.data() + from, text.size() - from, part.data(), part.size());
  if (found == nullptr) return std::string_view::npos;
  return static_cast<std::size_t>(static_cast<const char*>(found) - text.data());
}

std::size_t python_rfind(std::string_view text, std::string_view part) {
  const std::size_t at =
      python_find(std::string(text.rbegin(), text.rend()), std::string(part.rbegin(), part.rend()));
  return at == std::string_view::npos ? at : text.size() - at - part.size();
}

bool python_compare(std::string_view op, const PythonValue& a, const PythonValue& b) {
  if (op == "==") return python_equal(a, b);
  if (op == "!=") return !python_equal(a, b);
  if (op == "in") return contains(a, b);
  const auto ordered = [&](const auto& x, const auto& y) {
    return op == "<" ? x < y : op == "<=" ? x <= y : op == ">" ? x > y : x >= y;
  };
  const auto whole_a = python_integer(a);
  const auto whole_b = python_integer(b);
  if (whole_a && whole_b) return ordered(*whole_a, *whole_b);
  const auto real_a = python_number(a);
  const auto real_b = python_number(b);
  if (real_a && real_b) return ordered(*real_a, *real_b);
  const auto* text_a = as<std::string>(a);
  const auto* text_b = as<std::string>(b);
  if (text_a != nullptr && text_b != nullptr) return ordered(*text_a, *text_b);
  if (python_items(a) != nullptr && a.held.index() == b.held.index()) {
    return ordered_items(op, *python_items(a), *python_items(b));
  }
  python_fault("TypeError: '" + std::string(op) + "' not supported between instances of '" +
               std::string(python_type(a)) + "' and '" + std::string(python_type(b)) + "'");
}

PythonValue python_item(const PythonValue& of, const PythonValue& index) {
  if (const PythonList* items = python_items(of)) return (*items)[place_of(index, items->size())];
  if (const auto* text = as<std::string>(of)) {
    const auto letters = characters(*text);
    return {letters[place_of(index, letters.size())]};
  }
  if (const PythonDict* dict = as_dict(of)) {
    if (const PythonValue* value = python_entry(*dict, index)) return *value;
    python_fault("KeyError: " + python_text(index, true));
  }
  python_fault("TypeError: '" + std::string(python_type(of)) + "' object is not subscriptable");
}

PythonValue python_slice(const PythonValue& of, const PythonValue& begin, const PythonValue& end,
                         const PythonValue& step) {
  if (const auto* list = as<PythonList>(of)) return {sliced(*list, begin, end, step)};
  if (const auto* tuple = as<PythonTuple>(of))
    return {PythonTuple{sliced(tuple->items, begin, end, step)}};
  if (const auto* text = as<std::string>(of)) {
    std::string result;
    for (const std::string& one : sliced(characters(*text), begin, end, step)) result += one;
    return {std::move(result)};
  }
  python_fault("TypeError: '" + std::string(python_type(of)) + "' object is not subscriptable");
}

PythonValue python_to_integer(const PythonValue& value) {
  if (const auto whole = python_integer(value)) return {*whole};
  if (const double* real = as<double>(value)) {
    if (!(std::fabs(*real) < 9.2e18))
      python_fault("OverflowError: cannot convert float to integer");
    return {static_cast<std::int64_t>(*real)};
  }
  if (const std::string* text = as<std::string>(value)) {
    if (const auto result = read_number<std::int64_t>(*text)) return {*result};
    python_fault("ValueError: invalid literal for int() with base 10: " + quoted_text(*text));
  }
  python_fault("TypeError: int() argument must be a string or a real number, not '" +
               std::string(python_type(value)) + "'");
}

PythonValue python_to_float(const PythonValue& value) {
  if (const auto real = python_number(value)) return {*real};
  if (const std::string* text = as<std::string>(value)) {
    if (const auto result = read_number<double>(*text)) return {*result};
    python_fault("ValueError: could not convert string to float: " + quoted_text(*text));
  }
  python_fault("TypeError: float() argument must be a string or a real number, not '" +
               std::string(python_type(value)) + "'");
}

}  // namespace ros2wasm
