// Values of handles: their types, first values and copies. This file needs no ROS.
#include "hardware_interface/handle.hpp"

#include <array>

namespace hardware_interface {
namespace {

constexpr std::array<const char*, 9> kTypeNames = {"double", "float32", "bool",   "uint8", "int8",
                                                   "uint16", "int16",   "uint32", "int32"};

template <typename T>
HANDLE_DATATYPE integer(const std::string& text) {
  if (text.empty()) {
    return std::numeric_limits<T>::max();
  }
  if constexpr (std::is_signed_v<T>) {
    return stoi_generic<T>(text);
  } else {
    return stoui_generic<T>(text);
  }
}

/// The first value of an interface, from the text of its description, which may be empty.
HANDLE_DATATYPE first_value(HandleDataType type, const std::string& text) {
  switch (static_cast<HandleDataType::Value>(type)) {
    case HandleDataType::DOUBLE:
      return text.empty() ? std::numeric_limits<double>::quiet_NaN()
                          : hardware_interface::stod(text);
    case HandleDataType::FLOAT32:
      return text.empty() ? std::numeric_limits<float>::quiet_NaN()
                          : hardware_interface::stof(text);
    case HandleDataType::BOOL:
      return !text.empty() && parse_bool(text);
    case HandleDataType::UINT8:
      return integer<std::uint8_t>(text);
    case HandleDataType::INT8:
      return integer<std::int8_t>(text);
    case HandleDataType::UINT16:
      return integer<std::uint16_t>(text);
    case HandleDataType::INT16:
      return integer<std::int16_t>(text);
    case HandleDataType::UINT32:
      return integer<std::uint32_t>(text);
    case HandleDataType::INT32:
      return integer<std::int32_t>(text);
    case HandleDataType::UNKNOWN:
      break;
  }
  return std::monostate{};
}

}  // namespace

HandleDataType::HandleDataType(const std::string& data_type) {
  for (std::size_t i = 0; i < kTypeNames.size(); ++i) {
    if (data_type == kTypeNames[i]) {
      value_ = static_cast<Value>(i);
    }
  }
}

std::string HandleDataType::to_string() const {
  return value_ == UNKNOWN ? "unknown" : kTypeNames[static_cast<std::size_t>(value_)];
}

double HandleDataType::cast_to_double(const HANDLE_DATATYPE& value) const {
  if (value_ == UNKNOWN) {
    throw std::runtime_error("Data type : '" + to_string() + "' cannot be casted to double.");
  }
  if (value.index() != static_cast<std::size_t>(value_) + 1) {
    throw std::bad_variant_access();
  }
  return std::visit(
      [](const auto& held) {
        if constexpr (std::is_arithmetic_v<std::decay_t<decltype(held)>>) {
          return static_cast<double>(held);
        } else {
          return std::numeric_limits<double>::quiet_NaN();
        }
      },
      value);
}

Handle::Handle(const std::string& prefix_name, const std::string& interface_name,
               const std::string& data_type, const std::string& initial_value)
    : prefix_name_(prefix_name),
      interface_name_(interface_name),
      handle_name_(prefix_name + "/" + interface_name),
      data_type_(data_type) {
  if (data_type_ == HandleDataType::UNKNOWN) {
    throw std::runtime_error("Invalid data type: '" + data_type +
                             "' for interface: " + handle_name_ + ". Check supported types.");
  }
  try {
    value_ = first_value(data_type_, initial_value);
  } catch (const std::invalid_argument&) {
    throw std::invalid_argument("Invalid initial value: '" + initial_value +
                                "' parsed for interface: '" + handle_name_ + "' with type: '" +
                                data_type_.to_string() + "'");
  }
  value_ptr_ = std::get_if<double>(&value_);
}

Handle::Handle(const Handle& other) noexcept {
  copy(other);
}
Handle& Handle::operator=(const Handle& other) {
  if (this != &other) {
    copy(other);
  }
  return *this;
}
Handle::Handle(Handle&& other) noexcept {
  swap(other);
}
Handle& Handle::operator=(Handle&& other) {
  if (this != &other) {
    swap(other);
  }
  return *this;
}

double Handle::get_value() const {
  return get_optional<double>().value_or(std::numeric_limits<double>::quiet_NaN());
}

void Handle::refuse_double() const {
  throw std::runtime_error("Data type: '" + data_type_.to_string() +
                           "' will not be casted to double for interface: " + get_name() +
                           ". Use get_optional<" + data_type_.to_string() + ">() instead.");
}
void Handle::refuse_access() const {
  throw std::runtime_error("Invalid data type : access for interface : " + get_name() +
                           " expected : '" + data_type_.to_string() + "'");
}

void Handle::copy(const Handle& other) noexcept {
  const std::scoped_lock lock(other.handle_mutex_, handle_mutex_);
  prefix_name_ = other.prefix_name_;
  interface_name_ = other.interface_name_;
  handle_name_ = other.handle_name_;
  data_type_ = other.data_type_;
  value_ = other.value_;
  value_ptr_ = std::holds_alternative<std::monostate>(value_) ? other.value_ptr_
                                                              : std::get_if<double>(&value_);
}

void Handle::swap(Handle& other) noexcept {
  const std::scoped_lock lock(other.handle_mutex_, handle_mutex_);
  std::swap(prefix_name_, other.prefix_name_);
  std::swap(interface_name_, other.interface_name_);
  std::swap(handle_name_, other.handle_name_);
  std::swap(data_type_, other.data_type_);
  std::swap(value_, other.value_);
  std::swap(value_ptr_, other.value_ptr_);
  // A pointer into the value of the other handle now points into its own.
  for (Handle* const handle : {this, &other}) {
    if (!std::holds_alternative<std::monostate>(handle->value_)) {
      handle->value_ptr_ = std::get_if<double>(&handle->value_);
    }
  }
}

}  // namespace hardware_interface
