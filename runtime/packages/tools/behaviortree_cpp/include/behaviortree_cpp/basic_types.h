// Basic types of nodes and ports: kinds, states, values as texts, and descriptions of ports.
// Includes the standard headers that programs get from upstream's headers without including them.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <functional>
#include <iostream>
#include <memory>
#include <mutex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <thread>
#include <typeindex>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

#include "behaviortree_cpp/exceptions.h"
#include "behaviortree_cpp/utils/safe_any.hpp"

namespace BT {

enum class NodeType { UNDEFINED = 0, ACTION, CONDITION, CONTROL, DECORATOR, SUBTREE };

enum class NodeStatus { IDLE = 0, RUNNING = 1, SUCCESS = 2, FAILURE = 3, SKIPPED = 4 };

enum class PortDirection { INPUT, OUTPUT, INOUT };

inline bool isStatusActive(const NodeStatus& status) {
  return status != NodeStatus::IDLE && status != NodeStatus::SKIPPED;
}
inline bool isStatusCompleted(const NodeStatus& status) {
  return status == NodeStatus::SUCCESS || status == NodeStatus::FAILURE;
}

using StringView = std::string_view;
using Duration = std::chrono::high_resolution_clock::duration;
using TimePoint = std::chrono::high_resolution_clock::time_point;
using KeyValueVector = std::vector<std::pair<std::string, std::string>>;

template <typename T>
using Expected = nonstd::expected<T, std::string>;
template <typename T>
using Optional = nonstd::expected<T, std::string>;
using Result = Expected<std::monostate>;

struct AnyTypeAllowed {};

// --- texts ------------------------------------------------------------------------------------

[[nodiscard]] inline bool StartWith(StringView str, StringView prefix) {
  return str.substr(0, prefix.size()) == prefix;
}
[[nodiscard]] inline bool StartWith(StringView str, char prefix) {
  return !str.empty() && str.front() == prefix;
}

/// By a converter of JsonExporter. Throws RuntimeError when there is none or the text does not fit.
[[nodiscard]] Any convertFromJSON(StringView json_text, std::type_index type);
template <typename T>
[[nodiscard]] inline T convertFromJSON(StringView str) {
  return convertFromJSON(str, typeid(T)).template cast<T>();
}

/// User code specialises it for its own types. A text with `json:` before is read as JSON.
template <typename T>
[[nodiscard]] inline T convertFromString(StringView str) {
  if (StartWith(str, "json:")) return convertFromJSON<T>(str.substr(5));
  throw LogicError(
      "You didn't implement the template specialization of convertFromString for this type: " +
      demangle(typeid(T)));
}
template <>
std::string convertFromString<std::string>(StringView str);
template <>
int8_t convertFromString<int8_t>(StringView str);
template <>
int16_t convertFromString<int16_t>(StringView str);
template <>
int32_t convertFromString<int32_t>(StringView str);
template <>
int64_t convertFromString<int64_t>(StringView str);
template <>
uint8_t convertFromString<uint8_t>(StringView str);
template <>
uint16_t convertFromString<uint16_t>(StringView str);
template <>
uint32_t convertFromString<uint32_t>(StringView str);
template <>
uint64_t convertFromString<uint64_t>(StringView str);
template <>
float convertFromString<float>(StringView str);
template <>
double convertFromString<double>(StringView str);
template <>
bool convertFromString<bool>(StringView str);
template <>
std::vector<int> convertFromString<std::vector<int>>(StringView str);
template <>
std::vector<double> convertFromString<std::vector<double>>(StringView str);
template <>
std::vector<std::string> convertFromString<std::vector<std::string>>(StringView str);
template <>
NodeStatus convertFromString<NodeStatus>(StringView str);
template <>
NodeType convertFromString<NodeType>(StringView str);
template <>
PortDirection convertFromString<PortDirection>(StringView str);

template <typename T>
[[nodiscard]] std::string toStr(const T& value) {
  if constexpr (std::is_convertible_v<T, std::string>) {
    return value;
  } else if constexpr (std::is_arithmetic_v<T>) {
    return std::to_string(value);
  } else {
    throw LogicError("Function BT::toStr<T>() not specialized for type [" + demangle(typeid(T)) +
                     "]");
  }
}
template <>
std::string toStr<bool>(const bool& value);
template <>
std::string toStr<NodeStatus>(const NodeStatus& status);
template <>
std::string toStr<NodeType>(const NodeType& type);
template <>
std::string toStr<PortDirection>(const PortDirection& direction);
/// With the colours of terminals.
[[nodiscard]] std::string toStr(NodeStatus status, bool colored);
std::ostream& operator<<(std::ostream& os, const NodeStatus& status);
std::ostream& operator<<(std::ostream& os, const NodeType& type);
std::ostream& operator<<(std::ostream& os, const PortDirection& direction);

[[nodiscard]] std::vector<StringView> splitString(const StringView& text, char delimiter);

/// A value as it stands on a blackboard or in XML, as the type that is asked for. Throws.
template <typename T>
[[nodiscard]] T read_as(const Any& value) {
  if constexpr (std::is_same_v<T, Any>) {
    return value;
  } else {
    if constexpr (!std::is_same_v<T, std::string>) {
      if (value.isString()) return convertFromString<T>(value.cast<std::string>());
    }
    return value.cast<T>();
  }
}

// --- ports ------------------------------------------------------------------------------------

class TypeInfo {
 public:
  explicit TypeInfo(std::type_index type = typeid(AnyTypeAllowed)) : type_(type) {}
  [[nodiscard]] const std::type_index& type() const { return type_; }
  [[nodiscard]] std::string typeName() const { return demangle(type_); }

 private:
  std::type_index type_;
};

class PortInfo : public TypeInfo {
 public:
  explicit PortInfo(PortDirection direction = PortDirection::INOUT,
                    std::type_index type = typeid(AnyTypeAllowed))
      : TypeInfo(type), direction_(direction) {}

  [[nodiscard]] PortDirection direction() const { return direction_; }
  [[nodiscard]] const std::string& description() const { return description_; }
  void setDescription(StringView description) { description_ = description; }
  /// Empty when there is none.
  [[nodiscard]] const Any& defaultValue() const { return default_; }
  template <typename T>
  void setDefaultValue(const T& value) {
    default_ = Any(value);
  }

 private:
  PortDirection direction_;
  std::string description_;
  Any default_;
};

using PortsList = std::unordered_map<std::string, PortInfo>;

/// Throws RuntimeError for `name`, `ID` and what does not begin with a letter.
void check_port_name(StringView name);

template <typename T = AnyTypeAllowed>
[[nodiscard]] std::pair<std::string, PortInfo> CreatePort(PortDirection direction, StringView name,
                                                          StringView description = {}) {
  check_port_name(name);
  PortInfo port(direction, typeid(T));
  port.setDescription(description);
  return {std::string(name), std::move(port)};
}
template <typename T = AnyTypeAllowed>
[[nodiscard]] std::pair<std::string, PortInfo> InputPort(StringView name,
                                                         StringView description = {}) {
  return CreatePort<T>(PortDirection::INPUT, name, description);
}
template <typename T = AnyTypeAllowed>
[[nodiscard]] std::pair<std::string, PortInfo> OutputPort(StringView name,
                                                          StringView description = {}) {
  return CreatePort<T>(PortDirection::OUTPUT, name, description);
}
template <typename T = AnyTypeAllowed>
[[nodiscard]] std::pair<std::string, PortInfo> BidirectionalPort(StringView name,
                                                                 StringView description = {}) {
  return CreatePort<T>(PortDirection::INOUT, name, description);
}
template <typename T = AnyTypeAllowed, typename DefaultT = T>
[[nodiscard]] std::pair<std::string, PortInfo> InputPort(StringView name, const DefaultT& value,
                                                         StringView description) {
  auto port = CreatePort<T>(PortDirection::INPUT, name, description);
  port.second.setDefaultValue(value);
  return port;
}
template <typename T = AnyTypeAllowed, typename DefaultT = T>
[[nodiscard]] std::pair<std::string, PortInfo> BidirectionalPort(StringView name,
                                                                 const DefaultT& value,
                                                                 StringView description) {
  auto port = CreatePort<T>(PortDirection::INOUT, name, description);
  port.second.setDefaultValue(value);
  return port;
}

// --- what a class of nodes says of itself --------------------------------------------------------

template <typename T, typename = void>
struct has_static_method_providedPorts : std::false_type {};
template <typename T>
struct has_static_method_providedPorts<
    T, std::enable_if_t<std::is_same_v<decltype(T::providedPorts()), PortsList>>> : std::true_type {
};

template <typename T>
[[nodiscard]] PortsList getProvidedPorts() {
  if constexpr (has_static_method_providedPorts<T>::value) {
    return T::providedPorts();
  } else {
    return {};
  }
}

}  // namespace BT
