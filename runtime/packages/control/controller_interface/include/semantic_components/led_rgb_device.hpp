// A lamp with three colours.
#pragma once

#include <string>
#include <vector>

#include "semantic_components/semantic_component_command_interface.hpp"
#include "std_msgs/msg/color_rgba.hpp"

namespace semantic_components {

class LedRgbDevice : public SemanticComponentCommandInterface<std_msgs::msg::ColorRGBA> {
 public:
  explicit LedRgbDevice(const std::string& name, const std::string& interface_r,
                        const std::string& interface_g, const std::string& interface_b)
      : SemanticComponentCommandInterface(
            name,
            {{name + "/" + interface_r}, {name + "/" + interface_g}, {name + "/" + interface_b}}) {}

  /// False for a colour outside 0 to 1.
  bool set_values_from_message(const std_msgs::msg::ColorRGBA& message) override {
    for (const float part : {message.r, message.g, message.b}) {
      if (part < 0 || part > 1) {
        return false;
      }
    }
    return set_values({message.r, message.g, message.b});
  }
};

}  // namespace semantic_components
