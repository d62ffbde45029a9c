// An expression of Python as a tree. Pure. Failures are PythonFault.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bundler/launch/python/python_value.hpp"

namespace ros2wasm {

enum class PythonForm {
  kValue,
  kName,
  kList,
  kTuple,
  kDict,    ///< keys and values by turns
  kChoice,  ///< value, condition, other value
  kOr,      ///< any number of operands
  kAnd,     ///< any number of operands
  kNot,
  kComparison,  ///< operand, then pairs of the operator (a kName) and an operand
  kArithmetic,  ///< the same, from left to right
  kNegated,
  kItem,
  kSlice,  ///< the object, then begin, end and step; None for what is skipped
  kAttribute,
  kCall,           ///< the function, then the arguments
  kMethod,         ///< the object, then the arguments
  kComprehension,  ///< one kFor
  kFor,            ///< what is gone over, the element or another kFor, then conditions
};

struct PythonExpression {
  PythonForm form = PythonForm::kValue;
  std::string text;  ///< a name or an operator
  PythonValue value{PythonNone{}};
  std::vector<PythonExpression> parts;
  /// For a call, the names of its last arguments; for kFor, the names that it sets.
  std::vector<std::string> names;
};

[[nodiscard]] PythonExpression parse_python(std::string_view expression);

/// Whether Python takes it for a name: no keyword, no other signs.
[[nodiscard]] bool is_python_name(std::string_view text);

}  // namespace ros2wasm
