// The service types that this program has code for, by name. A program is linked whole, so there is
// no library to load for others.
#pragma once

#include <memory>
#include <string>

#include "rclcpp/detail/message_type.hpp"

namespace rclcpp {
namespace detail {

struct KnownService {
  const rosidl_service_type_support_t* type_support;
  std::shared_ptr<void> (*make_response)();
  KnownService* next = nullptr;
  bool entered = false;
};

void enter_known_service(KnownService& service);
/// By "package/srv/Name"; null when the program has none of that name.
const KnownService* find_known_service(const std::string& type_name);

/// Called by all that is made for a ServiceT.
template <typename ServiceT>
void know_service() {
  static KnownService service{
      rosidl_typesupport_cpp::get_service_type_support_handle<ServiceT>(),
      []() -> std::shared_ptr<void> { return std::make_shared<typename ServiceT::Response>(); }};
  enter_known_service(service);
}

}  // namespace detail
}  // namespace rclcpp
