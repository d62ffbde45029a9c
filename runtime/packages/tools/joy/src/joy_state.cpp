// See joy_state.hpp.
#include "joy_state.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace joy {

float axis_value(float raw, double deadzone) {
  if (std::isnan(raw)) return 0;
  const double value = std::clamp(static_cast<double>(raw), -1.0, 1.0);
  const double beyond = std::abs(value) - deadzone;
  if (beyond <= 0) return 0;
  return static_cast<float>(-std::copysign(beyond / (1 - deadzone), value));
}

void JoySettings::check() const {
  if (!(deadzone >= 0.0 && deadzone <= 1.0)) {
    throw std::runtime_error("Deadzone must be between 0.0 and 1.0");
  }
  if (!(autorepeat_rate >= 0.0)) throw std::runtime_error("Autorepeat rate must be >= 0.0");
  if (autorepeat_rate > 1000.0) throw std::runtime_error("Autorepeat rate must be <= 1000.0");
  if (coalesce_interval_ms < 0) throw std::runtime_error("coalesce_interval_ms must be positive");
}

int64_t JoySettings::autorepeat_interval_ms() const {
  // In ms: a longer interval would not fit into a timer's nanoseconds.
  constexpr double kMost = 1e12;
  return autorepeat_rate > 0 ? static_cast<int64_t>(std::min(1000.0 / autorepeat_rate, kMost)) : 0;
}

JoyState::JoyState(JoySettings settings) : settings_(settings) {}

void JoyState::open(const std::vector<float>& raw_axes, std::size_t buttons) {
  axes_.clear();
  for (const float raw : raw_axes) axes_.push_back(axis_value(raw, settings_.deadzone));
  buttons_.assign(buttons, 0);
  pressed_.assign(buttons, false);
}

void JoyState::close() {
  open({}, 0);
}

bool JoyState::move(std::size_t axis, float raw) {
  const float value = axis_value(raw, settings_.deadzone);
  if (value == axes_[axis]) return false;
  axes_[axis] = value;
  return true;
}

bool JoyState::press(std::size_t button, bool is_pressed) {
  if (pressed_[button] == is_pressed) return false;
  pressed_[button] = is_pressed;
  if (settings_.has_sticky_buttons && !is_pressed) return false;
  buttons_[button] = settings_.has_sticky_buttons ? 1 - buttons_[button] : (is_pressed ? 1 : 0);
  return true;
}

JoyChange JoyState::update(const std::vector<float>& raw_axes,
                           const std::vector<int32_t>& raw_buttons) {
  bool is_moved = false;
  for (std::size_t i = 0; i < std::min(axes_.size(), raw_axes.size()); ++i) {
    is_moved = move(i, raw_axes[i]) || is_moved;
  }
  bool is_pressed = false;
  for (std::size_t i = 0; i < std::min(buttons_.size(), raw_buttons.size()); ++i) {
    is_pressed = press(i, raw_buttons[i] != 0) || is_pressed;
  }
  if (is_pressed) return JoyChange::kButtons;
  return is_moved ? JoyChange::kAxes : JoyChange::kNone;
}

}  // namespace joy
