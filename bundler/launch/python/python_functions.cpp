// See python_functions.hpp. One row per function.
#include "bundler/launch/python/python_functions.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "bundler/launch/python/python_function_table.hpp"

namespace ros2wasm {
namespace {

constexpr std::int64_t kLongestRange = 100'000;
/// The limit for dictionaries that expressions make: each new key is compared with all others.
constexpr std::size_t kMostEntries = 1000;

using Arguments = PythonArguments;

/// The argument at a place, or of a name, or nullptr.
const PythonValue* argument(const Arguments& a, std::size_t at, std::string_view name) {
  return at < a.values.size() ? &a.values[at] : python_named(a, name);
}

PythonValue keyed(const PythonValue* key, const PythonValue& value) {
  return key == nullptr ? value : python_called(*key, {.values = {value}});
}

PythonValue extreme(std::string_view op, const Arguments& a) {
  const PythonList among = a.values.size() == 1 ? python_iterated(a.values[0]) : a.values;
  const PythonValue* key = python_named(a, "key");
  if (among.empty()) {
    if (const PythonValue* otherwise = python_named(a, "default")) return *otherwise;
    python_fault("ValueError: nothing to choose from");
  }
  const PythonValue* best = &among.front();
  for (const PythonValue& one : among)
    if (python_compare(op, keyed(key, one), keyed(key, *best))) best = &one;
  return *best;
}

PythonValue sorted(const Arguments& a) {
  std::vector<std::pair<PythonValue, PythonValue>> items;
  for (const PythonValue& one : python_iterated(a.values[0]))
    items.emplace_back(keyed(python_named(a, "key"), one), one);
  const PythonValue* turn = python_named(a, "reverse");
  const bool reverse = turn != nullptr && truth(*turn);
  std::stable_sort(items.begin(), items.end(), [reverse](const auto& x, const auto& y) {
    return python_compare(reverse ? ">" : "<", x.first, y.first);
  });
  PythonList result;
  for (auto& [key, one] : items) result.push_back(std::move(one));
  return {std::move(result)};
}

/// To the even neighbour in the middle, as Python rounds.
PythonValue rounded(const Arguments& a) {
  const PythonValue* places = argument(a, 1, "ndigits");
  const bool none = places == nullptr || std::holds_alternative<PythonNone>(places->held);
  if (none) return python_to_integer({std::nearbyint(python_real(a.values[0]))});
  const std::int64_t digits = python_whole(*places);
  if (digits < 0 || digits > 300) python_fault("ValueError: round() takes 0 to 300 digits here");
  if (const auto integer = python_integer(a.values[0])) return {*integer};
  // Through decimal digits, which round the exact value.
  double result = python_real(a.values[0]);
  std::array<char, 700> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), result,
                                 std::chars_format::fixed, static_cast<int>(digits))
                       .ptr;
  std::from_chars(buffer.data(), end, result);
  return {result};
}

PythonValue length(const Arguments& a) {
  const std::string_view type = python_type(a.values[0]);
  if (type != "list" && type != "tuple" && type != "dict" && type != "str")
    python_fault("TypeError: object of type '" + std::string(type) + "' has no len()");
  return {static_cast<std::int64_t>(python_iterated(a.values[0]).size())};
}

/// Appends in place, where `+` would copy the whole sum each time. False: these are not lists.
bool appended(PythonValue& sum, const PythonValue& more) {
  auto* list = std::get_if<PythonList>(&sum.held);
  const auto* items = std::get_if<PythonList>(&more.held);
  if (list == nullptr || items == nullptr) return false;
  if (list->size() + items->size() > kPythonLongest)
    python_fault("MemoryError: the result is too long");
  list->insert(list->end(), items->begin(), items->end());
  return true;
}

PythonValue summed(const Arguments& a) {
  const PythonValue* start = argument(a, 1, "start");
  PythonValue result = start != nullptr ? *start : PythonValue{std::int64_t{0}};
  if (std::holds_alternative<std::string>(result.held))
    python_fault("TypeError: sum() can't sum strings [use ''.join(seq) instead]");
  // A sum of tuples copies, so its work is bounded.
  std::size_t copied = 0;
  for (const PythonValue& one : python_iterated(a.values[0])) {
    if (appended(result, one)) continue;
    result = python_arithmetic("+", result, one);
    if (const PythonList* items = python_items(result)) copied += items->size();
    if (copied > 16 * kPythonLongest) python_fault("TimeoutError: this is too much work");
  }
  return result;
}

PythonValue to_integer(const Arguments& a) {
  const PythonValue* base = argument(a, 1, "base");
  if (base == nullptr) return python_to_integer(a.values[0]);
  const auto* text = std::get_if<std::string>(&a.values[0].held);
  if (text == nullptr) python_fault("TypeError: int() can't convert non-string with explicit base");
  std::string digits = *text;
  const std::int64_t radix = python_whole(*base);
  if (radix < 2 || radix > 36) python_fault("ValueError: int() base must be >= 2 and <= 36");
  if (radix == 16 && (digits.starts_with("0x") || digits.starts_with("0X"))) digits.erase(0, 2);
  std::int64_t result = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), result,
                                            static_cast<int>(radix));
  if (error != std::errc() || end != digits.data() + digits.size())
    python_fault("ValueError: invalid literal for int() with base " + std::to_string(radix) + ": " +
                 python_text(a.values[0], true));
  return {result};
}

PythonValue dictionary(const Arguments& a) {
  PythonDict result;
  const auto set = [&](const PythonValue& key, const PythonValue& value) {
    for (auto& [one, old] : result.entries) {
      if (!python_equal(one, key)) continue;
      old = value;
      return;
    }
    if (result.entries.size() == kMostEntries)
      python_fault("MemoryError: the dictionary is too large");
    result.entries.emplace_back(key, value);
  };
  if (!a.values.empty()) {
    if (const auto* other = std::get_if<std::shared_ptr<const PythonDict>>(&a.values[0].held)) {
      result.entries = (*other)->entries;
    } else {
      for (const PythonValue& pair : python_iterated(a.values[0])) {
        const PythonList both = python_iterated(pair);
        if (both.size() != 2) python_fault("ValueError: dict() takes pairs of a key and a value");
        set(both[0], both[1]);
      }
    }
  }
  for (const auto& [name, value] : a.named) set({name}, value);
  return python_dict(std::move(result));
}

PythonValue range(const Arguments& a) {
  const std::int64_t first = a.values.size() > 1 ? python_whole(a.values[0]) : 0;
  const std::int64_t last = python_whole(a.values[a.values.size() > 1 ? 1 : 0]);
  const std::int64_t step = a.values.size() > 2 ? python_whole(a.values[2]) : 1;
  if (step == 0) python_fault("ValueError: range() arg 3 must not be zero");
  PythonList result;
  for (std::int64_t i = first; step > 0 ? i < last : i > last;) {
    if (static_cast<std::int64_t>(result.size()) == kLongestRange)
      python_fault("MemoryError: the range is too long");
    result.emplace_back().held = i;
    if (__builtin_add_overflow(i, step, &i)) break;
  }
  return {std::move(result)};
}

PythonValue zipped(const Arguments& a) {
  std::vector<PythonList> lists;
  std::size_t shortest = a.values.empty() ? 0 : std::numeric_limits<std::size_t>::max();
  for (const PythonValue& one : a.values) {
    lists.push_back(python_iterated(one));
    shortest = std::min(shortest, lists.back().size());
  }
  PythonList result;
  for (std::size_t i = 0; i < shortest; ++i) {
    PythonTuple together;
    for (const PythonList& list : lists) together.items.push_back(list[i]);
    result.push_back({std::move(together)});
  }
  return {std::move(result)};
}

PythonValue enumerated(const Arguments& a) {
  const PythonValue* start = argument(a, 1, "start");
  std::int64_t number = start != nullptr ? python_whole(*start) : 0;
  PythonList result;
  for (const PythonValue& one : python_iterated(a.values[0]))
    result.push_back({PythonTuple{{PythonValue{number++}, one}}});
  return {std::move(result)};
}

PythonValue mapped(const Arguments& a) {
  PythonList result;
  const PythonValue zips = zipped({.values = PythonList(a.values.begin() + 1, a.values.end())});
  for (const PythonValue& together : *python_items(zips))
    result.push_back(python_called(a.values[0], {.values = *python_items(together)}));
  return {std::move(result)};
}

PythonValue filtered(const Arguments& a) {
  const bool plain = std::holds_alternative<PythonNone>(a.values[0].held);
  PythonList result;
  for (const PythonValue& one : python_iterated(a.values[1]))
    if (truth(plain ? one : python_called(a.values[0], {.values = {one}}))) result.push_back(one);
  return {std::move(result)};
}

PythonValue reversed(const Arguments& a) {
  PythonList result = python_iterated(a.values[0]);
  std::reverse(result.begin(), result.end());
  return {std::move(result)};
}

PythonValue absolute(const Arguments& a) {
  return python_real(a.values[0]) < 0 || std::signbit(python_real(a.values[0]))
             ? python_negated(a.values[0])
             : a.values[0];
}

PythonValue any_of(const Arguments& a) {
  const PythonList items = python_iterated(a.values[0]);
  return {std::any_of(items.begin(), items.end(), truth)};
}
PythonValue all_of(const Arguments& a) {
  const PythonList items = python_iterated(a.values[0]);
  return {std::all_of(items.begin(), items.end(), truth)};
}

PythonValue first_or(const Arguments& a, PythonValue (*convert)(const PythonValue&),
                     PythonValue otherwise) {
  return a.values.empty() ? std::move(otherwise) : convert(a.values[0]);
}

PythonValue code_point(const Arguments& a) {
  const auto* text = std::get_if<std::string>(&a.values[0].held);
  if (text == nullptr || text->size() != 1)
    python_fault("TypeError: ord() takes one ASCII character here");
  return {std::int64_t{static_cast<unsigned char>(text->front())}};
}

const PythonTable& builtins() {
  static const PythonTable table = [] {
    constexpr std::size_t many = 1000;
    const auto max = [](const Arguments& a) { return extreme(">", a); };
    const auto min = [](const Arguments& a) { return extreme("<", a); };
    PythonTable t;
    add_python_function(t, "abs", 1, 1, absolute);
    add_python_function(t, "all", 1, 1, all_of);
    add_python_function(t, "any", 1, 1, any_of);
    add_python_function(t, "bool", 0, 1, [](const Arguments& a) {
      return PythonValue{!a.values.empty() && truth(a.values[0])};
    });
    add_python_function(t, "dict", 0, 1, dictionary, "*");
    add_python_function(t, "divmod", 2, 2, [](const Arguments& a) {
      return PythonValue{PythonTuple{{python_arithmetic("//", a.values[0], a.values[1]),
                                      python_arithmetic("%", a.values[0], a.values[1])}}};
    });
    add_python_function(t, "enumerate", 1, 2, enumerated, "start");
    add_python_function(t, "filter", 2, 2, filtered);
    add_python_function(t, "float", 0, 1,
                        [](const Arguments& a) { return first_or(a, python_to_float, {0.0}); });
    add_python_function(
        t, "int", 0, 2,
        [](const Arguments& a) {
          return a.values.empty() ? PythonValue{std::int64_t{0}} : to_integer(a);
        },
        "base");
    add_python_function(t, "len", 1, 1, length);
    add_python_function(t, "list", 0, 1, [](const Arguments& a) {
      return PythonValue{a.values.empty() ? PythonList{} : python_iterated(a.values[0])};
    });
    add_python_function(t, "map", 2, many, mapped);
    add_python_function(t, "max", 1, many, max, "key default");
    add_python_function(t, "min", 1, many, min, "key default");
    add_python_function(t, "ord", 1, 1, code_point);
    add_python_function(t, "range", 1, 3, range);
    add_python_function(t, "repr", 1, 1, [](const Arguments& a) {
      return PythonValue{python_text(a.values[0], true)};
    });
    add_python_function(t, "reversed", 1, 1, reversed);
    add_python_function(t, "round", 1, 2, rounded, "ndigits");
    add_python_function(t, "sorted", 1, 1, sorted, "key reverse");
    add_python_function(t, "str", 0, 1, [](const Arguments& a) {
      return PythonValue{a.values.empty() ? std::string() : python_text(a.values[0])};
    });
    add_python_function(t, "sum", 1, 2, summed, "start");
    add_python_function(t, "tuple", 0, 1, [](const Arguments& a) {
      return PythonValue{
          PythonTuple{a.values.empty() ? PythonList{} : python_iterated(a.values[0])}};
    });
    add_python_function(t, "zip", 0, many, zipped);
    return t;
  }();
  return table;
}

}  // namespace

void add_python_function(PythonTable& table, const std::string& name, std::size_t least,
                         std::size_t most,
                         const std::function<PythonValue(const PythonArguments&)>& call,
                         const std::string& names) {
  const auto checked = [=](const PythonArguments& a) {
    for (const auto& [one, value] : a.named)
      if (names != "*" && (" " + names + " ").find(" " + one + " ") == std::string::npos)
        python_fault("TypeError: " + name + "() got an unexpected keyword argument '" + one + "'");
    if (a.values.size() < least || a.values.size() > most)
      python_fault("TypeError: " + name + "() got " + std::to_string(a.values.size()) +
                   " arguments");
    return call(a);
  };
  table.emplace(name, std::make_shared<const PythonFunction>(PythonFunction{name, checked}));
}

std::optional<PythonValue> python_function(const PythonTable& table, const std::string& name) {
  const auto row = table.find(name);
  return row == table.end() ? std::nullopt : std::optional(PythonValue{row->second});
}

const PythonValue* python_named(const PythonArguments& arguments, std::string_view name) {
  for (const auto& [one, value] : arguments.named)
    if (one == name) return &value;
  return nullptr;
}

double python_real(const PythonValue& value) {
  const auto one = python_number(value);
  if (!one) python_fault("TypeError: must be real number, not " + std::string(python_type(value)));
  return *one;
}

std::int64_t python_whole(const PythonValue& value) {
  const auto one = python_integer(value);
  if (!one)
    python_fault("TypeError: '" + std::string(python_type(value)) +
                 "' object cannot be interpreted as an integer");
  return *one;
}

std::optional<PythonValue> python_builtin(const std::string& name) {
  if (name == "True") return PythonValue{true};
  if (name == "False") return PythonValue{false};
  if (name == "None") return PythonValue{PythonNone{}};
  return python_function(builtins(), name);
}

PythonValue python_called(const PythonValue& function, const PythonArguments& arguments) {
  const auto* one = std::get_if<std::shared_ptr<const PythonFunction>>(&function.held);
  if (one == nullptr)
    python_fault("TypeError: '" + std::string(python_type(function)) + "' object is not callable");
  return (*one)->call(arguments);
}

std::optional<PythonValue> python_attribute(const PythonValue& of, const std::string& name) {
  if (const auto* space = std::get_if<std::shared_ptr<const PythonNamespace>>(&of.held))
    return (*space)->attribute(name);
  const auto* dict = std::get_if<std::shared_ptr<const PythonDict>>(&of.held);
  if (dict == nullptr || !(*dict)->dotted) return std::nullopt;
  const PythonValue* value = python_entry(**dict, {name});
  return value != nullptr ? std::optional(*value) : std::nullopt;
}

}  // namespace ros2wasm
