// The functions and names that expressions of Python have: built-in ones and those of math; and
// the methods of texts, lists and dictionaries. Pure.
#pragma once

#include <optional>
#include <string>

#include "bundler/launch/python/python_value.hpp"

namespace ros2wasm {

/// A built-in function, True, False or None.
[[nodiscard]] std::optional<PythonValue> python_builtin(const std::string& name);
/// A function or number of the module math.
[[nodiscard]] std::optional<PythonValue> python_math(const std::string& name);

[[nodiscard]] PythonValue python_called(const PythonValue& function,
                                        const PythonArguments& arguments);
/// The attribute of a namespace, or of a dictionary whose entries are attributes.
[[nodiscard]] std::optional<PythonValue> python_attribute(const PythonValue& of,
                                                          const std::string& name);
/// Methods of texts, lists and dictionaries, but those that would change them.
[[nodiscard]] PythonValue python_method(const PythonValue& of, const std::string& method,
                                        const PythonArguments& arguments);

}  // namespace ros2wasm
