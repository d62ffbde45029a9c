// See python_expression.hpp. What stands behind a decided `or` or in the other branch of an `if`
// is read but never evaluated.
#include "bundler/launch/python/python_expression.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "bundler/launch/python/python_functions.hpp"
#include "bundler/launch/python/python_parser.hpp"

namespace ros2wasm {
namespace {

using Form = PythonForm;
using Expression = PythonExpression;

void spend(const PythonScope& scope, std::size_t steps) {
  scope.limits->steps_left -= static_cast<std::int64_t>(steps);
  if (scope.limits->steps_left < 0) python_fault("TimeoutError: this is too much work");
}

class Level {
 public:
  explicit Level(const PythonScope& scope) : left_(scope.limits->levels_left) {
    if (--left_ < 0) python_fault("RecursionError: expressions lead too deep into each other");
  }
  ~Level() { ++left_; }
  Level(const Level&) = delete;
  Level& operator=(const Level&) = delete;

 private:
  int& left_;
};

/// The cost in steps of copying a value, or of looking something up in it.
std::size_t weight(const PythonValue& value) {
  if (const auto* text = std::get_if<std::string>(&value.held)) return text->size() / 8;
  if (const auto* dict = std::get_if<std::shared_ptr<const PythonDict>>(&value.held))
    return (*dict)->entries.size() / 16;
  std::size_t result = 0;
  if (const PythonList* items = python_items(value))
    for (const PythonValue& one : *items) result += 1 + weight(one);
  return result;
}

PythonValue value_of(const Expression& expression, const PythonScope& scope);

PythonList values_of(const std::vector<Expression>& parts, const PythonScope& scope) {
  PythonList result;
  for (const Expression& one : parts) result.push_back(value_of(one, scope));
  return result;
}

PythonValue named(const std::string& name, const PythonScope& scope) {
  auto value = scope.name(name);
  if (!value) python_fault("NameError: name '" + name + "' is not defined");
  return std::move(*value);
}

PythonValue compared(const std::vector<Expression>& parts, const PythonScope& scope) {
  PythonValue left = value_of(parts[0], scope);
  for (std::size_t i = 1; i < parts.size(); i += 2) {
    PythonValue right = value_of(parts[i + 1], scope);
    const std::string& op = parts[i].text;
    const bool holds =
        op == "not in" ? !python_compare("in", left, right) : python_compare(op, left, right);
    if (!holds) return {false};
    left = std::move(right);
  }
  return {true};
}

PythonValue calculated(const std::vector<Expression>& parts, const PythonScope& scope) {
  PythonValue left = value_of(parts[0], scope);
  for (std::size_t i = 1; i < parts.size(); i += 2) {
    left = python_arithmetic(parts[i].text, left, value_of(parts[i + 1], scope));
    spend(scope, weight(left));
  }
  return left;
}

/// The first whose truth is `wanted`, or the last.
PythonValue decided(const std::vector<Expression>& parts, bool wanted, const PythonScope& scope) {
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    PythonValue value = value_of(parts[i], scope);
    if (truth(value) == wanted) return value;
  }
  return value_of(parts.back(), scope);
}

PythonValue dictionary(const std::vector<Expression>& parts, const PythonScope& scope) {
  PythonList pairs;
  for (std::size_t i = 0; i + 1 < parts.size(); i += 2)
    pairs.push_back({PythonTuple{{value_of(parts[i], scope), value_of(parts[i + 1], scope)}}});
  return python_called(*python_builtin("dict"), {.values = {{std::move(pairs)}}});
}

/// The arguments, the last of them by the call's names.
PythonArguments arguments_of(const Expression& call, const PythonScope& scope) {
  PythonArguments result;
  const std::size_t first_named = call.parts.size() - call.names.size();
  for (std::size_t i = 1; i < call.parts.size(); ++i) {
    PythonValue value = value_of(call.parts[i], scope);
    if (i < first_named) {
      result.values.push_back(std::move(value));
    } else {
      result.named.emplace_back(call.names[i - first_named], std::move(value));
    }
  }
  return result;
}

PythonValue attribute(const Expression& expression, const PythonScope& scope) {
  const PythonValue of = value_of(expression.parts[0], scope);
  if (auto value = python_attribute(of, expression.text)) return std::move(*value);
  python_fault("AttributeError: '" + std::string(python_type(of)) + "' object has no attribute '" +
               expression.text + "'");
}

/// The scope inside a loop: the names of the loop hide outer names.
PythonScope inside(const PythonScope& outer, const std::vector<std::string>& names,
                   const PythonList& values) {
  return {.name =
              [&](const std::string& name) {
                const auto at = std::find(names.begin(), names.end(), name);
                return at == names.end()
                           ? outer.name(name)
                           : std::optional(values[static_cast<std::size_t>(at - names.begin())]);
              },
          .limits = outer.limits};
}

void loop(const Expression& loop_for, const PythonScope& scope, PythonList& into) {
  const auto& parts = loop_for.parts;
  for (const PythonValue& item : python_iterated(value_of(parts[0], scope))) {
    const PythonList values = loop_for.names.size() == 1 ? PythonList{item} : python_iterated(item);
    if (values.size() != loop_for.names.size())
      python_fault("ValueError: the number of values to unpack differs from that of names");
    const PythonScope inner = inside(scope, loop_for.names, values);
    const bool holds = std::all_of(parts.begin() + 2, parts.end(), [&](const Expression& one) {
      return truth(value_of(one, inner));
    });
    spend(scope, 1);
    if (!holds) continue;
    if (parts[1].form == Form::kFor) {
      loop(parts[1], inner, into);
    } else {
      into.push_back(value_of(parts[1], inner));
    }
  }
}

PythonValue computed(const Expression& expression, const PythonScope& scope) {
  const std::vector<Expression>& parts = expression.parts;
  const auto part = [&](std::size_t i) { return value_of(parts[i], scope); };
  switch (expression.form) {
    case Form::kValue:
      return expression.value;
    case Form::kName:
      return named(expression.text, scope);
    case Form::kList:
      return {values_of(parts, scope)};
    case Form::kTuple:
      return {PythonTuple{values_of(parts, scope)}};
    case Form::kDict:
      return dictionary(parts, scope);
    case Form::kChoice:
      return part(truth(part(1)) ? 0 : 2);
    case Form::kOr:
      return decided(parts, true, scope);
    case Form::kAnd:
      return decided(parts, false, scope);
    case Form::kNot:
      return {!truth(part(0))};
    case Form::kComparison:
      return compared(parts, scope);
    case Form::kArithmetic:
      return calculated(parts, scope);
    case Form::kNegated:
      return python_negated(part(0));
    case Form::kItem: {
      const PythonValue of = part(0);
      return python_item(of, part(1));
    }
    case Form::kSlice: {
      const PythonList all = values_of(parts, scope);
      return python_slice(all[0], all[1], all[2], all[3]);
    }
    case Form::kAttribute:
      return attribute(expression, scope);
    case Form::kCall: {
      const PythonValue function = part(0);
      return python_called(function, arguments_of(expression, scope));
    }
    case Form::kMethod: {
      const PythonValue of = part(0);
      return python_method(of, expression.text, arguments_of(expression, scope));
    }
    case Form::kComprehension: {
      PythonList result;
      loop(parts[0], scope, result);
      return {std::move(result)};
    }
    case Form::kFor:
      break;
  }
  return {PythonNone{}};
}

PythonValue value_of(const Expression& expression, const PythonScope& scope) {
  const Level level(scope);
  spend(scope, 1);
  PythonValue result = computed(expression, scope);
  spend(scope, weight(result));
  return result;
}

std::optional<PythonValue> launch_name(const std::string& name) {
  if (name == "math")
    return PythonValue{std::make_shared<const PythonNamespace>(
        PythonNamespace{.name = "math", .attribute = python_math})};
  auto value = python_builtin(name);
  return value ? value : python_math(name);
}

}  // namespace

PythonValue python_evaluated(std::string_view expression, const PythonScope& scope) {
  return value_of(parse_python(expression), scope);
}

Outcome<std::string> evaluate_python(std::string_view expression, const SourceSpan& span) {
  try {
    PythonLimits limits;
    return python_text(python_evaluated(expression, {.name = launch_name, .limits = &limits}));
  } catch (const PythonFault& fault) {
    return Diagnostic{.code = "R2W0411",
                      .message = "`$(eval ...)` cannot be evaluated: " + fault.message,
                      .span = span,
                      .why = {"the expression is: " + std::string(expression.substr(0, 200))}};
  }
}

}  // namespace ros2wasm
