// See python_value.hpp: what + - * / // % ** do.
#include <cmath>

#include "bundler/launch/python/python_format.hpp"
#include "bundler/launch/python/python_value.hpp"

namespace ros2wasm {
namespace {

template <typename T>
const T* as(const PythonValue& value) {
  return std::get_if<T>(&value.held);
}

[[noreturn]] void unsupported(std::string_view op, const PythonValue& a, const PythonValue& b) {
  python_fault("TypeError: unsupported operand type(s) for " + std::string(op) + ": '" +
               std::string(python_type(a)) + "' and '" + std::string(python_type(b)) + "'");
}

/// Whole numbers are of 64 bits here; Python's have no end.
std::int64_t checked(std::string_view op, std::int64_t a, std::int64_t b) {
  std::int64_t result = 0;
  const bool over = op == "+"   ? __builtin_add_overflow(a, b, &result)
                    : op == "-" ? __builtin_sub_overflow(a, b, &result)
                                : __builtin_mul_overflow(a, b, &result);
  if (over) python_fault("OverflowError: the result is larger than 64 bits");
  return result;
}

std::int64_t floor_divided(std::int64_t a, std::int64_t b) {
  if (b == 0) python_fault("ZeroDivisionError: integer division or modulo by zero");
  if (b == -1) return checked("-", 0, a);
  const std::int64_t quotient = a / b;
  return a % b != 0 && (a < 0) != (b < 0) ? quotient - 1 : quotient;
}

double real_power(double base, double exponent) {
  if (base == 0 && exponent < 0)
    python_fault("ZeroDivisionError: 0.0 cannot be raised to a negative power");
  const double result = std::pow(base, exponent);
  if (std::isnan(result) && !std::isnan(base) && !std::isnan(exponent))
    python_fault("ValueError: complex numbers are not known here");
  if (std::isinf(result) && !std::isinf(base) && !std::isinf(exponent))
    python_fault("OverflowError: (34, 'Numerical result out of range')");
  return result;
}

PythonValue whole_power(std::int64_t base, std::int64_t exponent) {
  if (exponent < 0) return {real_power(static_cast<double>(base), static_cast<double>(exponent))};
  std::int64_t result = 1;
  for (std::int64_t i = 0; i < exponent; ++i) {
    if (base == 0 || base == 1) return {base};
    if (base == -1) return {exponent % 2 == 0 ? std::int64_t{1} : std::int64_t{-1}};
    result = checked("*", result, base);
  }
  return {result};
}

PythonValue of_integers(std::string_view op, std::int64_t a, std::int64_t b) {
  if (op == "//") return {floor_divided(a, b)};
  if (op == "%") return {b == -1 ? 0 : a - floor_divided(a, b) * b};
  if (op == "**") return whole_power(a, b);
  if (op == "/") {
    if (b == 0) python_fault("ZeroDivisionError: division by zero");
    return {static_cast<double>(a) / static_cast<double>(b)};
  }
  return {checked(op, a, b)};
}

/// `a // b` or `a % b`, the quotient by way of the exact rest.
double divided(double a, double b, bool quotient) {
  double rest = std::fmod(a, b);
  double whole = (a - rest) / b;
  if (rest == 0) {
    rest = std::copysign(0.0, b);
  } else if ((rest < 0) != (b < 0)) {
    rest += b;
    whole -= 1;
  }
  if (!quotient) return rest;
  return whole == 0 ? std::copysign(0.0, a / b) : std::round(whole);
}

PythonValue of_numbers(std::string_view op, double a, double b) {
  if (op == "+") return {a + b};
  if (op == "-") return {a - b};
  if (op == "*") return {a * b};
  if (op == "**") return {real_power(a, b)};
  if (b == 0) python_fault("ZeroDivisionError: float division by zero");
  if (op == "/") return {a / b};
  return {divided(a, b, op == "//")};
}

/// Letters and values, also of lists in lists: a copy takes as much again.
std::size_t size_of_copy(const PythonList& items) {
  std::size_t size = items.size();
  for (const PythonValue& one : items) {
    if (const auto* text = as<std::string>(one)) size += text->size();
    if (const PythonList* inner = python_items(one)) size += size_of_copy(*inner);
  }
  return size;
}

std::size_t size_of_copy(const std::string& text) {
  return text.size();
}

template <typename T>
T repeated(const T& one, std::int64_t times) {
  T result;
  if (times <= 0 || one.empty()) return result;
  if (static_cast<std::uint64_t>(times) > kPythonLongest / size_of_copy(one))
    python_fault("MemoryError: the result is too long");
  for (std::int64_t i = 0; i < times; ++i) result.insert(result.end(), one.begin(), one.end());
  return result;
}

template <typename T>
T joined(const T& a, const T& b) {
  if (a.size() + b.size() > kPythonLongest) python_fault("MemoryError: the result is too long");
  T result = a;
  result.insert(result.end(), b.begin(), b.end());
  return result;
}

}  // namespace

PythonValue python_arithmetic(std::string_view op, const PythonValue& a, const PythonValue& b) {
  const auto whole_a = python_integer(a);
  const auto whole_b = python_integer(b);
  if (whole_a && whole_b) return of_integers(op, *whole_a, *whole_b);
  const auto real_a = python_number(a);
  const auto real_b = python_number(b);
  if (real_a && real_b) return of_numbers(op, *real_a, *real_b);
  if (op == "+" && a.held.index() == b.held.index()) {
    if (const auto* text = as<std::string>(a))
      return {joined(*text, std::get<std::string>(b.held))};
    if (const auto* list = as<PythonList>(a)) return {joined(*list, std::get<PythonList>(b.held))};
    if (const auto* tuple = as<PythonTuple>(a))
      return {PythonTuple{joined(tuple->items, std::get<PythonTuple>(b.held).items)}};
  }
  if (op == "*" && (whole_a || whole_b)) {
    const PythonValue& many = whole_a ? b : a;
    const std::int64_t times = whole_a ? *whole_a : *whole_b;
    if (const auto* text = as<std::string>(many)) return {repeated(*text, times)};
    if (const auto* list = as<PythonList>(many)) return {repeated(*list, times)};
    if (const auto* tuple = as<PythonTuple>(many))
      return {PythonTuple{repeated(tuple->items, times)}};
  }
  if (op == "%") {
    if (const auto* text = as<std::string>(a)) return {python_percent(*text, b)};
  }
  unsupported(op, a, b);
}

PythonValue python_negated(const PythonValue& value) {
  if (const auto whole = python_integer(value)) return {checked("-", 0, *whole)};
  if (const double* real = as<double>(value)) return {-*real};
  python_fault("TypeError: bad operand type for unary -: '" + std::string(python_type(value)) +
               "'");
}

}  // namespace ros2wasm
