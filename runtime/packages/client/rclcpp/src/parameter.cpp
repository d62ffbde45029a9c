// Parameters and their values, as objects and as text.
#include "rclcpp/parameter.hpp"

#include <cstdio>
#include <ostream>

#include "rclcpp/node_interfaces/node_parameters.hpp"

namespace rclcpp {
namespace {

template <typename ElementT, typename TextT>
std::string join(const std::vector<ElementT>& elements, const TextT& text_of) {
  std::string text = "[";
  for (size_t i = 0; i < elements.size(); ++i) {
    text += (i == 0 ? "" : ", ") + text_of(elements[i]);
  }
  return text + "]";
}

// As a stream prints it.
std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%g", value);
  return text;
}

std::string byte_text(uint8_t value) {
  char text[8];
  std::snprintf(text, sizeof(text), value == 0 ? "0" : "0x%x", value);
  return text;
}

template <typename FromT, typename ToT>
std::vector<ToT> convert(const std::vector<FromT>& from) {
  return std::vector<ToT>(from.begin(), from.end());
}

}  // namespace

std::string to_string(ParameterType type) {
  switch (type) {
    case PARAMETER_NOT_SET:
      return "not set";
    case PARAMETER_BOOL:
      return "bool";
    case PARAMETER_INTEGER:
      return "integer";
    case PARAMETER_DOUBLE:
      return "double";
    case PARAMETER_STRING:
      return "string";
    case PARAMETER_BYTE_ARRAY:
      return "byte_array";
    case PARAMETER_BOOL_ARRAY:
      return "bool_array";
    case PARAMETER_INTEGER_ARRAY:
      return "integer_array";
    case PARAMETER_DOUBLE_ARRAY:
      return "double_array";
    case PARAMETER_STRING_ARRAY:
      return "string_array";
  }
  return "unknown type";
}

std::ostream& operator<<(std::ostream& os, ParameterType type) {
  return os << to_string(type);
}

std::string to_string(const ParameterValue& value) {
  switch (value.get_type()) {
    case PARAMETER_NOT_SET:
      return "not set";
    case PARAMETER_BOOL:
      return value.get<bool>() ? "true" : "false";
    case PARAMETER_INTEGER:
      return std::to_string(value.get<int64_t>());
    case PARAMETER_DOUBLE:
      return std::to_string(value.get<double>());
    case PARAMETER_STRING:
      return value.get<std::string>();
    case PARAMETER_BYTE_ARRAY:
      return join(value.get<PARAMETER_BYTE_ARRAY>(), byte_text);
    case PARAMETER_BOOL_ARRAY:
      return join(value.get<PARAMETER_BOOL_ARRAY>(),
                  [](bool element) { return std::string(element ? "true" : "false"); });
    case PARAMETER_INTEGER_ARRAY:
      return join(value.get<PARAMETER_INTEGER_ARRAY>(),
                  [](int64_t element) { return std::to_string(element); });
    case PARAMETER_DOUBLE_ARRAY:
      return join(value.get<PARAMETER_DOUBLE_ARRAY>(), number_text);
    case PARAMETER_STRING_ARRAY:
      return join(value.get<PARAMETER_STRING_ARRAY>(),
                  [](const std::string& element) { return element; });
  }
  return "unknown type";
}

ParameterValue::ParameterValue() {
  value_.type = PARAMETER_NOT_SET;
}

ParameterValue::ParameterValue(const rcl_interfaces::msg::ParameterValue& value) : value_(value) {
  if (value.type > PARAMETER_STRING_ARRAY) {
    throw std::runtime_error("Unknown type: " + std::to_string(value.type));
  }
}
ParameterValue::ParameterValue(bool bool_value) {
  value_.bool_value = bool_value;
  value_.type = PARAMETER_BOOL;
}
ParameterValue::ParameterValue(int int_value) : ParameterValue(static_cast<int64_t>(int_value)) {}
ParameterValue::ParameterValue(int64_t int_value) {
  value_.integer_value = int_value;
  value_.type = PARAMETER_INTEGER;
}
ParameterValue::ParameterValue(float double_value)
    : ParameterValue(static_cast<double>(double_value)) {}
ParameterValue::ParameterValue(double double_value) {
  value_.double_value = double_value;
  value_.type = PARAMETER_DOUBLE;
}
ParameterValue::ParameterValue(const std::string& string_value) {
  value_.string_value = string_value;
  value_.type = PARAMETER_STRING;
}
ParameterValue::ParameterValue(const char* string_value)
    : ParameterValue(std::string(string_value)) {}
ParameterValue::ParameterValue(const std::vector<uint8_t>& byte_array_value) {
  value_.byte_array_value = byte_array_value;
  value_.type = PARAMETER_BYTE_ARRAY;
}
ParameterValue::ParameterValue(const std::vector<bool>& bool_array_value) {
  value_.bool_array_value = bool_array_value;
  value_.type = PARAMETER_BOOL_ARRAY;
}
ParameterValue::ParameterValue(const std::vector<int>& int_array_value)
    : ParameterValue(convert<int, int64_t>(int_array_value)) {}
ParameterValue::ParameterValue(const std::vector<int64_t>& int_array_value) {
  value_.integer_array_value = int_array_value;
  value_.type = PARAMETER_INTEGER_ARRAY;
}
ParameterValue::ParameterValue(const std::vector<float>& double_array_value)
    : ParameterValue(convert<float, double>(double_array_value)) {}
ParameterValue::ParameterValue(const std::vector<double>& double_array_value) {
  value_.double_array_value = double_array_value;
  value_.type = PARAMETER_DOUBLE_ARRAY;
}
ParameterValue::ParameterValue(const std::vector<std::string>& string_array_value) {
  value_.string_array_value = string_array_value;
  value_.type = PARAMETER_STRING_ARRAY;
}

Parameter::Parameter() = default;
Parameter::Parameter(const std::string& name) : name_(name) {}
Parameter::Parameter(const std::string& name, const ParameterValue& value)
    : name_(name), value_(value) {}
Parameter::Parameter(const node_interfaces::ParameterInfo& parameter_info)
    : Parameter(parameter_info.descriptor.name, parameter_info.value) {}

bool Parameter::operator==(const Parameter& rhs) const {
  return name_ == rhs.name_ && value_ == rhs.value_;
}

Parameter Parameter::from_parameter_msg(const rcl_interfaces::msg::Parameter& parameter) {
  return Parameter(parameter.name, ParameterValue(parameter.value));
}

rcl_interfaces::msg::Parameter Parameter::to_parameter_msg() const {
  rcl_interfaces::msg::Parameter parameter;
  parameter.name = name_;
  parameter.value = value_.to_value_msg();
  return parameter;
}

std::string _to_json_dict_entry(const Parameter& param) {
  return "\"" + param.get_name() + "\": {\"type\": \"" + param.get_type_name() +
         "\", \"value\": \"" + param.value_to_string() + "\"}";
}

std::ostream& operator<<(std::ostream& os, const Parameter& pv) {
  return os << std::to_string(pv);
}

std::ostream& operator<<(std::ostream& os, const std::vector<Parameter>& parameters) {
  return os << std::to_string(parameters);
}

}  // namespace rclcpp

std::string std::to_string(const rclcpp::Parameter& param) {
  return "{\"name\": \"" + param.get_name() + "\", \"type\": \"" + param.get_type_name() +
         "\", \"value\": \"" + param.value_to_string() + "\"}";
}

std::string std::to_string(const std::vector<rclcpp::Parameter>& parameters) {
  std::string text = "{";
  for (size_t i = 0; i < parameters.size(); ++i) {
    text += (i == 0 ? "" : ", ") + rclcpp::_to_json_dict_entry(parameters[i]);
  }
  return text + "}";
}
