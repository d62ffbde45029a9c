// Types known by name only.
#include <cctype>

#include "rclcpp/exceptions.hpp"
#include "rclcpp/generic_publisher.hpp"

namespace rclcpp {
namespace detail {
namespace {

// "pkg/msg/Name" from "pkg/msg/Name" or "pkg/Name".
std::string full_type_name(const std::string& name) {
  const size_t first = name.find('/');
  const size_t last = name.rfind('/');
  if (first == std::string::npos || first == 0 || last + 1 == name.size()) {
    throw std::runtime_error(
        "Message type is not of the form package/type and cannot be processed");
  }
  return first == last ? name.substr(0, first) + "/msg" + name.substr(first) : name;
}

}  // namespace

NamedType::NamedType(const std::string& name)
    : name_(full_type_name(name)),
      callbacks_{name_.c_str(), "", nullptr, nullptr, nullptr, nullptr},
      type_support_{"rosidl_typesupport_wasm_cpp", &callbacks_, nullptr} {}

}  // namespace detail
}  // namespace rclcpp
