// How functions of expressions are told: name, number of arguments, what they do. For
// python_functions.cpp and python_math.cpp.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "bundler/launch/python/python_value.hpp"

namespace ros2wasm {

using PythonTable = std::map<std::string, std::shared_ptr<const PythonFunction>, std::less<>>;

/// A function of `least` to `most` arguments. `names`: those that may be named; `*`: all.
void add_python_function(PythonTable& table, const std::string& name, std::size_t least,
                         std::size_t most,
                         const std::function<PythonValue(const PythonArguments&)>& call,
                         const std::string& names = {});

/// The function, as a value.
[[nodiscard]] std::optional<PythonValue> python_function(const PythonTable& table,
                                                         const std::string& name);

/// The argument of a name, or nullptr.
[[nodiscard]] const PythonValue* python_named(const PythonArguments& arguments,
                                              std::string_view name);

/// A fault when it is none.
[[nodiscard]] double python_real(const PythonValue& value);
[[nodiscard]] std::int64_t python_whole(const PythonValue& value);

}  // namespace ros2wasm
