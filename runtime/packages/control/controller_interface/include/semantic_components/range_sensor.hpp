// A measured distance.
#pragma once

#include <limits>
#include <string>

#include "semantic_components/semantic_component_interface.hpp"
#include "sensor_msgs/msg/range.hpp"

namespace semantic_components {

class RangeSensor : public SemanticComponentInterface<sensor_msgs::msg::Range> {
 public:
  explicit RangeSensor(const std::string& name)
      : SemanticComponentInterface(name, {name + "/range"}) {}

  /// Metres.
  float get_range() const {
    const auto value = state_interfaces_[0].get().get_optional();
    return value ? static_cast<float>(*value) : std::numeric_limits<float>::quiet_NaN();
  }
  bool get_values_as_message(sensor_msgs::msg::Range& message) const {
    message.range = get_range();
    return true;
  }
};

}  // namespace semantic_components
