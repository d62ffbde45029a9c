// Used by generated headers: one walk over the parameters of a file. A walk either declares and
// reads them all, or takes the new value of one. Nothing here is meant for the code of nodes.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <string_view>

#include "rclcpp/logger.hpp"
#include "rclcpp/node_interfaces/node_parameters_interface.hpp"
#include "rclcpp/parameter.hpp"
#include "rsl/static_string.hpp"
#include "rsl/static_vector.hpp"
#include "tl/expected.hpp"

namespace generate_parameter_library {

using Result = tl::expected<void, std::string>;
using Check = Result (*)(const rclcpp::Parameter& parameter);

/// A parameter, as its YAML file describes it. The texts must live as long as the program.
class Field {
 public:
  constexpr explicit Field(const char* description) : description_(description) {}
  constexpr Field& required() { return is_required_ = true, *this; }
  constexpr Field& read_only() { return is_read_only_ = true, *this; }
  constexpr Field& constraints(const char* text) { return constraints_ = text, *this; }
  constexpr Field& range(double from, double to) { return range_ = {from, to}, *this; }
  constexpr Field& integer_range(int64_t from, int64_t to) {
    return integer_range_ = {from, to}, *this;
  }

  constexpr bool is_required() const { return is_required_; }
  rcl_interfaces::msg::ParameterDescriptor descriptor() const;

 private:
  template <class T>
  struct Range {
    T from;
    T to;
  };

  const char* description_;
  const char* constraints_ = "";
  bool is_required_ = false;  ///< without a default
  bool is_read_only_ = false;
  Range<double> range_{1.0, 0.0};  ///< none, when it is empty
  Range<int64_t> integer_range_{1, 0};
};

/// As parameters have them.
template <class T>
const T& plain(const T& value) {
  return value;
}
template <size_t capacity>
std::string plain(const rsl::StaticString<capacity>& value) {
  return rsl::to_string(value);
}
template <class T, size_t capacity>
std::vector<T> plain(const rsl::StaticVector<T, capacity>& value) {
  return rsl::to_vector(value);
}

class Fields {
 public:
  using ParametersInterface = rclcpp::node_interfaces::NodeParametersInterface;

  /// Declares what the node has not declared yet, and reads. `prefix` is empty or ends with a dot.
  Fields(ParametersInterface& node, const rclcpp::Logger& logger, const std::string& prefix)
      : node_(&node), logger_(logger), prefix_(prefix) {}
  /// Takes the value of `changed`, if it is one of these.
  Fields(const rclcpp::Parameter& changed, const rclcpp::Logger& logger, const std::string& prefix);
  Fields(const Fields&) = delete;
  Fields& operator=(const Fields&) = delete;

  /// `value`: the default before, the parameter's value after. Throws
  /// rclcpp::exceptions::InvalidParameterValueException for a value that is refused at the start,
  /// and ParameterUninitializedException for a required one that nobody gives.
  template <class T>
  void add(std::string_view name, T& value, const Field& field, Check check = nullptr) {
    const rclcpp::Parameter* now = nullptr;
    if (changed_ != nullptr) {
      now = checked_change(name, check);
    } else {
      now = declared(name, rclcpp::ParameterValue(plain(value)), field, check);
    }
    if (now != nullptr) value = now->get_value<std::decay_t<decltype(plain(value))>>();
  }

  bool has_declared() const { return has_declared_; }
  /// Why the change is refused; nothing when it is accepted, or is none of these parameters.
  const Result& result() const { return result_; }

 private:
  const rclcpp::Parameter* declared(std::string_view name, const rclcpp::ParameterValue& initial,
                                    const Field& field, Check check);
  const rclcpp::Parameter* checked_change(std::string_view name, Check check);
  void log(const rclcpp::Parameter& parameter) const;

  ParametersInterface* node_ = nullptr;
  const rclcpp::Parameter* changed_ = nullptr;
  std::string_view changed_name_;  ///< without the prefix; empty when it has another prefix
  const rclcpp::Logger& logger_;
  const std::string& prefix_;
  rclcpp::Parameter last_;
  bool has_declared_ = false;
  Result result_;
};

}  // namespace generate_parameter_library
