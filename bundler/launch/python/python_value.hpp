// The values of Python expressions, their texts, and what operators do with them, as Python does
// it. Failures are PythonFault, which stays in this folder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace ros2wasm {

struct PythonFault {
  std::string message;  ///< such as "ZeroDivisionError: division by zero"
};
[[noreturn]] void python_fault(std::string message);

/// The most letters of a text and items of a list: what is evaluated while packing has an end.
inline constexpr std::size_t kPythonLongest = 1U << 20U;

struct PythonNone {
  bool operator==(const PythonNone&) const = default;
};
struct PythonValue;
using PythonList = std::vector<PythonValue>;
struct PythonTuple {
  PythonList items;
};
struct PythonDict;
struct PythonFunction;
struct PythonNamespace;

/// Nothing changes a value once it is made.
struct PythonValue {
  std::variant<PythonNone, bool, std::int64_t, double, std::string, PythonList, PythonTuple,
               std::shared_ptr<const PythonDict>, std::shared_ptr<const PythonFunction>,
               std::shared_ptr<const PythonNamespace>>
      held;
};

struct PythonDict {
  std::vector<std::pair<PythonValue, PythonValue>> entries;  ///< keys are unique
  bool dotted = false;  ///< `d.key` is `d['key']`, as in dictionaries that xacro reads from YAML
};

struct PythonArguments {
  PythonList values;
  std::vector<std::pair<std::string, PythonValue>> named;
};

struct PythonFunction {
  std::string name;
  std::function<PythonValue(const PythonArguments&)> call;
};

/// An object that only has attributes: a module, a namespace of xacro.
struct PythonNamespace {
  std::string name;
  std::function<std::optional<PythonValue>(const std::string& attribute)> attribute;
};

[[nodiscard]] PythonValue python_dict(PythonDict dict);
/// The value of a key, or nullptr.
[[nodiscard]] const PythonValue* python_entry(const PythonDict& dict, const PythonValue& key);

[[nodiscard]] bool truth(const PythonValue& value);
/// As str() writes it; `quoted`: as repr() does.
[[nodiscard]] std::string python_text(const PythonValue& value, bool quoted = false);
[[nodiscard]] std::string_view python_type(const PythonValue& value);
[[nodiscard]] bool python_equal(const PythonValue& a, const PythonValue& b);

/// Booleans count as 0 and 1.
[[nodiscard]] std::optional<std::int64_t> python_integer(const PythonValue& value);
[[nodiscard]] std::optional<double> python_number(const PythonValue& value);
/// The items of a list or tuple, or nullptr.
[[nodiscard]] const PythonList* python_items(const PythonValue& value);
/// Whether lists, tuples and dictionaries are nested more than `levels` deep.
[[nodiscard]] bool python_nests_deeper(const PythonValue& value, int levels);
/// The values that `for` iterates over: items, keys, characters.
[[nodiscard]] PythonList python_iterated(const PythonValue& value);

/// `op` is one of + - * / // % **.
[[nodiscard]] PythonValue python_arithmetic(std::string_view op, const PythonValue& a,
                                            const PythonValue& b);
/// `op` is one of < <= > >= == != in.
/// Like std::string_view::find() and rfind(), but linear: their time grows with the sum of both
/// sizes, not with the product.
[[nodiscard]] std::size_t python_find(std::string_view text, std::string_view part,
                                      std::size_t from = 0);
[[nodiscard]] std::size_t python_rfind(std::string_view text, std::string_view part);

[[nodiscard]] bool python_compare(std::string_view op, const PythonValue& a, const PythonValue& b);
[[nodiscard]] PythonValue python_negated(const PythonValue& value);
[[nodiscard]] PythonValue python_item(const PythonValue& of, const PythonValue& index);
/// `of[begin:end:step]`; None for a part that is skipped.
[[nodiscard]] PythonValue python_slice(const PythonValue& of, const PythonValue& begin,
                                       const PythonValue& end, const PythonValue& step);

/// int() and float() of one value.
[[nodiscard]] PythonValue python_to_integer(const PythonValue& value);
[[nodiscard]] PythonValue python_to_float(const PythonValue& value);

}  // namespace ros2wasm
