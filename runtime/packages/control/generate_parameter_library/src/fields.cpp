// See fields.hpp.
#include "generate_parameter_library/fields.hpp"

#include "rclcpp/exceptions.hpp"
#include "rclcpp/logging.hpp"

namespace generate_parameter_library {

rcl_interfaces::msg::ParameterDescriptor Field::descriptor() const {
  rcl_interfaces::msg::ParameterDescriptor descriptor;
  descriptor.description = description_;
  descriptor.additional_constraints = constraints_;
  descriptor.read_only = is_read_only_;
  if (range_.from <= range_.to) {
    descriptor.floating_point_range.resize(1);
    descriptor.floating_point_range[0].from_value = range_.from;
    descriptor.floating_point_range[0].to_value = range_.to;
  }
  if (integer_range_.from <= integer_range_.to) {
    descriptor.integer_range.resize(1);
    descriptor.integer_range[0].from_value = integer_range_.from;
    descriptor.integer_range[0].to_value = integer_range_.to;
  }
  return descriptor;
}

Fields::Fields(const rclcpp::Parameter& changed, const rclcpp::Logger& logger,
               const std::string& prefix)
    : changed_(&changed), logger_(logger), prefix_(prefix) {
  const std::string& name = changed.get_name();
  if (name.compare(0, prefix.size(), prefix) == 0)
    changed_name_ = std::string_view(name).substr(prefix.size());
}

const rclcpp::Parameter* Fields::declared(std::string_view name,
                                          const rclcpp::ParameterValue& initial, const Field& field,
                                          Check check) {
  const std::string full_name = prefix_ + std::string(name);
  if (!node_->has_parameter(full_name)) {
    has_declared_ = true;
    if (field.is_required()) {
      node_->declare_parameter(full_name, initial.get_type(), field.descriptor());
    } else {
      node_->declare_parameter(full_name, initial, field.descriptor());
    }
  }
  last_ = node_->get_parameter(full_name);
  log(last_);
  if (check == nullptr) return &last_;
  if (const Result result = check(last_); !result) {
    throw rclcpp::exceptions::InvalidParameterValueException(
        "Invalid value set during initialization for parameter '" + std::string(name) +
        "': " + result.error());
  }
  return &last_;
}

const rclcpp::Parameter* Fields::checked_change(std::string_view name, Check check) {
  if (name != changed_name_ || !result_) return nullptr;
  if (check != nullptr) result_ = check(*changed_);
  if (!result_) return nullptr;
  log(*changed_);
  return changed_;
}

void Fields::log(const rclcpp::Parameter& parameter) const {
  RCLCPP_DEBUG_STREAM(logger_, parameter.get_name() << ": " << parameter.get_type_name() << " = "
                                                    << parameter.value_to_string());
}

}  // namespace generate_parameter_library
