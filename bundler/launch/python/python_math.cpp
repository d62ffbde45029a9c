// See python_functions.hpp: the module math. One row per function.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "bundler/launch/python/python_function_table.hpp"
#include "bundler/launch/python/python_functions.hpp"

namespace ros2wasm {
namespace {

using Arguments = PythonArguments;

/// Adds a function of one number; an argument or result outside of its domain is a fault.
void add_real(PythonTable& table, const std::string& name, double (*function)(double)) {
  add_python_function(table, name, 1, 1, [function](const Arguments& a) {
    const double from = python_real(a.values[0]);
    const double result = function(from);
    if (std::isnan(result) && !std::isnan(from)) python_fault("ValueError: math domain error");
    if (std::isinf(result) && !std::isinf(from)) python_fault("OverflowError: math range error");
    return PythonValue{result};
  });
}

void add_pair(PythonTable& table, const std::string& name, double (*function)(double, double)) {
  add_python_function(table, name, 2, 2, [function](const Arguments& a) {
    const double result = function(python_real(a.values[0]), python_real(a.values[1]));
    if (std::isnan(result) && !std::isnan(python_real(a.values[0])) &&
        !std::isnan(python_real(a.values[1])))
      python_fault("ValueError: math domain error");
    return PythonValue{result};
  });
}

void add_whole(PythonTable& table, const std::string& name, double (*function)(double)) {
  add_python_function(table, name, 1, 1, [function](const Arguments& a) {
    if (const auto one = python_integer(a.values[0])) return PythonValue{*one};
    return python_to_integer({function(python_real(a.values[0]))});
  });
}

void add_test(PythonTable& table, const std::string& name, bool (*function)(double)) {
  add_python_function(table, name, 1, 1, [function](const Arguments& a) {
    return PythonValue{function(python_real(a.values[0]))};
  });
}

PythonValue logarithm(const Arguments& a) {
  for (const PythonValue& one : a.values)
    if (python_real(one) <= 0) python_fault("ValueError: math domain error");
  const double natural = std::log(python_real(a.values[0]));
  if (a.values.size() == 1) return {natural};
  return python_arithmetic("/", {natural}, {std::log(python_real(a.values[1]))});
}

PythonValue close(const Arguments& a) {
  const auto given = [&](const char* name, double otherwise) {
    const PythonValue* value = python_named(a, name);
    return value != nullptr ? python_real(*value) : otherwise;
  };
  const double x = python_real(a.values[0]);
  const double y = python_real(a.values[1]);
  const double larger = std::max(std::fabs(x), std::fabs(y));
  const double away = std::fabs(x - y);
  return {x == y || away <= std::max(given("rel_tol", 1e-9) * larger, given("abs_tol", 0.0))};
}

PythonValue distance(const Arguments& a) {
  double sum = 0;
  for (const PythonValue& one : a.values) sum = std::hypot(sum, python_real(one));
  return {sum};
}

PythonValue product(const Arguments& a) {
  PythonValue result{std::int64_t{1}};
  for (const PythonValue& one : python_iterated(a.values[0]))
    result = python_arithmetic("*", result, one);
  return result;
}

PythonValue factorial(const Arguments& a) {
  const std::int64_t n = python_whole(a.values[0]);
  if (n < 0) python_fault("ValueError: factorial() not defined for negative values");
  PythonValue result{std::int64_t{1}};
  for (std::int64_t i = 2; i <= n; ++i) result = python_arithmetic("*", result, {i});
  return result;
}

const PythonTable& math_functions() {
  static const PythonTable table = [] {
    constexpr std::size_t many = 1000;
    PythonTable t;
    add_real(t, "acos", std::acos);
    add_real(t, "acosh", std::acosh);
    add_real(t, "asin", std::asin);
    add_real(t, "asinh", std::asinh);
    add_real(t, "atan", std::atan);
    add_pair(t, "atan2", std::atan2);
    add_real(t, "atanh", std::atanh);
    add_whole(t, "ceil", std::ceil);
    add_pair(t, "copysign", std::copysign);
    add_real(t, "cos", std::cos);
    add_real(t, "cosh", std::cosh);
    add_real(t, "degrees", [](double x) { return x * (180.0 / std::numbers::pi); });
    add_real(t, "erf", std::erf);
    add_real(t, "exp", std::exp);
    add_real(t, "expm1", std::expm1);
    add_real(t, "fabs", std::fabs);
    add_python_function(t, "factorial", 1, 1, factorial);
    add_whole(t, "floor", std::floor);
    add_pair(t, "fmod", std::fmod);
    add_python_function(t, "gcd", 2, 2, [](const Arguments& a) {
      return PythonValue{std::gcd(python_whole(a.values[0]), python_whole(a.values[1]))};
    });
    add_python_function(t, "hypot", 0, many, distance);
    add_python_function(t, "isclose", 2, 2, close, "rel_tol abs_tol");
    add_test(t, "isfinite", [](double x) { return std::isfinite(x); });
    add_test(t, "isinf", [](double x) { return std::isinf(x); });
    add_test(t, "isnan", [](double x) { return std::isnan(x); });
    add_python_function(t, "log", 1, 2, logarithm);
    add_real(t, "log10", std::log10);
    add_real(t, "log1p", std::log1p);
    add_real(t, "log2", std::log2);
    add_pair(t, "pow", std::pow);
    add_python_function(t, "prod", 1, 1, product);
    add_real(t, "radians", [](double x) { return x * (std::numbers::pi / 180.0); });
    add_real(t, "sin", std::sin);
    add_real(t, "sinh", std::sinh);
    add_real(t, "sqrt", std::sqrt);
    add_real(t, "tan", std::tan);
    add_real(t, "tanh", std::tanh);
    add_whole(t, "trunc", std::trunc);
    return t;
  }();
  return table;
}

}  // namespace

std::optional<PythonValue> python_math(const std::string& name) {
  if (name == "pi") return PythonValue{std::numbers::pi};
  if (name == "tau") return PythonValue{2 * std::numbers::pi};
  if (name == "e") return PythonValue{std::numbers::e};
  if (name == "inf") return PythonValue{std::numeric_limits<double>::infinity()};
  if (name == "nan") return PythonValue{std::numeric_limits<double>::quiet_NaN()};
  return python_function(math_functions(), name);
}

}  // namespace ros2wasm
