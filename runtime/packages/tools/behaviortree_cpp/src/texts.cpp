// Values as texts and texts as values; see basic_types.h.
#include <cxxabi.h>

#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <limits>
#include <ostream>

#include "behaviortree_cpp/basic_types.h"

namespace BT {
namespace {

[[noreturn]] void refuse(StringView text, const char* type) {
  throw RuntimeError("Can't convert string [" + std::string(text) + "] to " + type);
}

StringView without_space(StringView text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())) != 0) {
    text.remove_prefix(1);
  }
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) {
    text.remove_suffix(1);
  }
  return text;
}

template <typename T>
T whole_number(StringView text, const char* type) {
  const std::string copy(without_space(text));
  char* end = nullptr;
  errno = 0;
  if constexpr (std::is_signed_v<T>) {
    const long long value = std::strtoll(copy.c_str(), &end, 10);
    if (copy.empty() || *end != '\0' || errno != 0 || value < std::numeric_limits<T>::min() ||
        value > std::numeric_limits<T>::max()) {
      refuse(text, type);
    }
    return static_cast<T>(value);
  } else {
    const unsigned long long value = std::strtoull(copy.c_str(), &end, 10);
    if (copy.empty() || copy[0] == '-' || *end != '\0' || errno != 0 ||
        value > std::numeric_limits<T>::max()) {
      refuse(text, type);
    }
    return static_cast<T>(value);
  }
}

template <typename T>
std::vector<T> values_between(StringView text, char delimiter) {
  std::vector<T> values;
  for (const StringView part : splitString(text, delimiter)) {
    values.push_back(convertFromString<T>(part));
  }
  return values;
}

template <typename T>
struct Named {
  T value;
  const char* name;
};
constexpr Named<NodeStatus> kStatuses[] = {{NodeStatus::IDLE, "IDLE"},
                                           {NodeStatus::RUNNING, "RUNNING"},
                                           {NodeStatus::SUCCESS, "SUCCESS"},
                                           {NodeStatus::FAILURE, "FAILURE"},
                                           {NodeStatus::SKIPPED, "SKIPPED"}};
constexpr Named<NodeType> kTypes[] = {
    {NodeType::UNDEFINED, "Undefined"}, {NodeType::ACTION, "Action"},
    {NodeType::CONDITION, "Condition"}, {NodeType::CONTROL, "Control"},
    {NodeType::DECORATOR, "Decorator"}, {NodeType::SUBTREE, "SubTree"}};
constexpr Named<PortDirection> kDirections[] = {{PortDirection::INPUT, "Input"},
                                                {PortDirection::OUTPUT, "Output"},
                                                {PortDirection::INOUT, "InOut"}};

template <typename T, std::size_t N>
std::string name_of(const Named<T> (&names)[N], T value) {
  for (const auto& one : names) {
    if (one.value == value) return one.name;
  }
  return "Undefined";
}
template <typename T, std::size_t N>
T value_of(const Named<T> (&names)[N], StringView name, const char* type) {
  for (const auto& one : names) {
    if (one.name == name) return one.value;
  }
  refuse(name, type);
}

}  // namespace

std::string demangle(const std::type_index& index) {
  if (index == typeid(std::string)) return "std::string";
  int status = 0;
  char* const text = abi::__cxa_demangle(index.name(), nullptr, nullptr, &status);
  std::string name = status == 0 ? text : index.name();
  std::free(text);  // NOLINT: the compiler's own library asks for it
  return name;
}

template <>
std::string convertFromString<std::string>(StringView str) {
  return std::string(str);
}
template <>
int8_t convertFromString<int8_t>(StringView str) {
  return whole_number<int8_t>(str, "int8_t");
}
template <>
int16_t convertFromString<int16_t>(StringView str) {
  return whole_number<int16_t>(str, "int16_t");
}
template <>
int32_t convertFromString<int32_t>(StringView str) {
  return whole_number<int32_t>(str, "int");
}
template <>
int64_t convertFromString<int64_t>(StringView str) {
  return whole_number<int64_t>(str, "int64_t");
}
template <>
uint8_t convertFromString<uint8_t>(StringView str) {
  return whole_number<uint8_t>(str, "uint8_t");
}
template <>
uint16_t convertFromString<uint16_t>(StringView str) {
  return whole_number<uint16_t>(str, "uint16_t");
}
template <>
uint32_t convertFromString<uint32_t>(StringView str) {
  return whole_number<uint32_t>(str, "unsigned int");
}
template <>
uint64_t convertFromString<uint64_t>(StringView str) {
  return whole_number<uint64_t>(str, "uint64_t");
}
template <>
double convertFromString<double>(StringView str) {
  const std::string copy(without_space(str));
  char* end = nullptr;
  const double value = std::strtod(copy.c_str(), &end);
  if (copy.empty() || *end != '\0') refuse(str, "double");
  return value;
}
template <>
float convertFromString<float>(StringView str) {
  return static_cast<float>(convertFromString<double>(str));
}
template <>
bool convertFromString<bool>(StringView str) {
  if (str == "1" || str == "true" || str == "TRUE" || str == "True") return true;
  if (str == "0" || str == "false" || str == "FALSE" || str == "False") return false;
  throw RuntimeError("convertFromString(): invalid bool conversion");
}
template <>
std::vector<int> convertFromString<std::vector<int>>(StringView str) {
  return values_between<int>(str, ';');
}
template <>
std::vector<double> convertFromString<std::vector<double>>(StringView str) {
  return values_between<double>(str, ';');
}
template <>
std::vector<std::string> convertFromString<std::vector<std::string>>(StringView str) {
  return values_between<std::string>(str, ';');
}
template <>
NodeStatus convertFromString<NodeStatus>(StringView str) {
  return value_of(kStatuses, str, "NodeStatus");
}
template <>
NodeType convertFromString<NodeType>(StringView str) {
  return value_of(kTypes, str, "NodeType");
}
template <>
PortDirection convertFromString<PortDirection>(StringView str) {
  return value_of(kDirections, str, "PortDirection");
}

template <>
std::string toStr<bool>(const bool& value) {
  return value ? "true" : "false";
}
template <>
std::string toStr<NodeStatus>(const NodeStatus& status) {
  return name_of(kStatuses, status);
}
template <>
std::string toStr<NodeType>(const NodeType& type) {
  return name_of(kTypes, type);
}
template <>
std::string toStr<PortDirection>(const PortDirection& direction) {
  return name_of(kDirections, direction);
}
std::string toStr(NodeStatus status, bool colored) {
  if (!colored) return toStr(status);
  constexpr const char* kColours[] = {"36", "33", "32", "31", "34"};  // in the order of NodeStatus
  return std::string("\x1b[") + kColours[static_cast<int>(status)] + "m" + toStr(status) +
         "\x1b[0m";
}
std::ostream& operator<<(std::ostream& os, const NodeStatus& status) {
  return os << toStr(status);
}
std::ostream& operator<<(std::ostream& os, const NodeType& type) {
  return os << toStr(type);
}
std::ostream& operator<<(std::ostream& os, const PortDirection& direction) {
  return os << toStr(direction);
}

std::vector<StringView> splitString(const StringView& text, char delimiter) {
  std::vector<StringView> parts;
  StringView rest = text;
  while (!rest.empty()) {
    const std::size_t end = rest.find(delimiter);
    parts.push_back(rest.substr(0, end));
    if (end == StringView::npos) break;
    rest.remove_prefix(end + 1);
  }
  return parts;
}

void check_port_name(StringView name) {
  if (name.empty() || name == "name" || name == "ID" ||
      std::isalpha(static_cast<unsigned char>(name[0])) == 0) {
    throw RuntimeError(
        "The name of a port must not be `name` or `ID` and must start with an alphabetic "
        "character. Underscore is reserved.");
  }
}

}  // namespace BT
