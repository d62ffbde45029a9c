// Which velocity a joystick asks for: buttons that allow it, axes and their scales. Pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace teleop_twist_joy {

/// Along and about the axes of the robot, in m/s and rad/s.
struct Velocity {
  double x = 0;
  double y = 0;
  double z = 0;
  double roll = 0;
  double pitch = 0;
  double yaw = 0;
};

/// One direction of the robot.
struct Axis {
  int64_t index = -1;  ///< of the joystick's axis; negative: none
  double scale = 0;    ///< the velocity at the end of the axis
  double turbo = 0;    ///< as scale, while the turbo button is held
};

struct Mapping {
  bool require_enable_button = true;
  int64_t enable_button = 5;
  int64_t enable_turbo_button = -1;  ///< negative: none
  /// Whether a robot that goes backwards turns as a car does.
  bool inverted_reverse = false;
  Axis x{5, 0.5, 1.0};
  Axis y;
  Axis z;
  Axis yaw{2, 0.5, 1.0};
  Axis pitch;
  Axis roll;
};

inline bool is_pressed(const std::vector<int32_t>& buttons, int64_t index) {
  return index >= 0 && static_cast<std::size_t>(index) < buttons.size() &&
         buttons[static_cast<std::size_t>(index)] != 0;
}

inline double value(const std::vector<float>& axes, const Axis& axis, bool is_turbo) {
  if (axis.index < 0 || static_cast<std::size_t>(axis.index) >= axes.size()) return 0;
  return axes[static_cast<std::size_t>(axis.index)] * (is_turbo ? axis.turbo : axis.scale);
}

class Pilot {
 public:
  /// The velocity to send, if one is: while a button allows it, and once, zero, when none does any
  /// more.
  std::optional<Velocity> drive(const Mapping& mapping, const std::vector<float>& axes,
                                const std::vector<int32_t>& buttons) {
    const bool is_turbo = is_pressed(buttons, mapping.enable_turbo_button);
    const bool is_enabled =
        is_turbo || !mapping.require_enable_button || is_pressed(buttons, mapping.enable_button);
    if (!is_enabled) {
      if (has_stopped_) return {};
      has_stopped_ = true;
      return Velocity();
    }
    has_stopped_ = false;
    Velocity result;
    result.x = value(axes, mapping.x, is_turbo);
    result.y = value(axes, mapping.y, is_turbo);
    result.z = value(axes, mapping.z, is_turbo);
    result.roll = value(axes, mapping.roll, is_turbo);
    result.pitch = value(axes, mapping.pitch, is_turbo);
    result.yaw = value(axes, mapping.yaw, is_turbo);
    if (mapping.inverted_reverse && result.x < 0) result.yaw = -result.yaw;
    return result;
  }

 private:
  bool has_stopped_ = false;
};

}  // namespace teleop_twist_joy
