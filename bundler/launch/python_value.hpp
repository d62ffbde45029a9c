// The values of python_expression.cpp and what can be done with them, as Python does it. Failures
// are PythonFault, caught in python_expression.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ros2wasm {

struct PythonFault {
  std::string message;  ///< such as "ZeroDivisionError: division by zero"
};

struct PythonNone {
  bool operator==(const PythonNone&) const = default;
};
struct PythonValue;
using PythonList = std::vector<PythonValue>;

struct PythonValue {
  std::variant<PythonNone, bool, std::int64_t, double, std::string, PythonList> held;
};

[[nodiscard]] bool truth(const PythonValue& value);
/// As str() writes it; `quoted`: as repr() does.
[[nodiscard]] std::string python_text(const PythonValue& value, bool quoted = false);
[[nodiscard]] std::string_view python_type(const PythonValue& value);
[[nodiscard]] bool python_equal(const PythonValue& a, const PythonValue& b);

/// `op` is one of + - * / // % **.
[[nodiscard]] PythonValue python_arithmetic(std::string_view op, const PythonValue& a,
                                            const PythonValue& b);
/// `op` is one of < <= > >= == != in.
[[nodiscard]] bool python_compare(std::string_view op, const PythonValue& a, const PythonValue& b);
[[nodiscard]] PythonValue python_negated(const PythonValue& value);
[[nodiscard]] PythonValue python_item(const PythonValue& of, const PythonValue& index);

/// Built-in functions, and those of math by `math.` or their bare names.
[[nodiscard]] PythonValue python_call(std::string_view function, const PythonList& arguments);
/// Methods of texts and lists.
[[nodiscard]] PythonValue python_method(const PythonValue& of, std::string_view method,
                                        const PythonList& arguments);
/// True, False, None, pi, e, inf, nan, tau. False when there is no such name.
[[nodiscard]] bool python_name(std::string_view name, PythonValue& into);

}  // namespace ros2wasm
