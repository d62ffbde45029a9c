// Axes and buttons as messages of `joy` have them, from those of a device. Pure.
#pragma once

#include <cstdint>
#include <vector>

namespace joy {

/// `raw` is a device's axis, -1 to 1 with right and down positive; the result has left and up
/// positive, is 0 within the dead zone (0 to 1) and reaches 1 at its end.
[[nodiscard]] float axis_value(float raw, double deadzone);

/// The parameters of a node, checked.
struct JoySettings {
  double deadzone = 0.05;
  /// In Hz; 0: only changes are published.
  double autorepeat_rate = 20.0;
  /// A press switches a button on or off, its release does nothing.
  bool has_sticky_buttons = false;
  int64_t coalesce_interval_ms = 1;

  /// Throws std::runtime_error with a message for the user.
  void check() const;
  /// 0: never.
  [[nodiscard]] int64_t autorepeat_interval_ms() const;
};

enum class JoyChange {
  kNone,
  kAxes,     ///< is published after the coalescing interval
  kButtons,  ///< is published at once
};

class JoyState {
 public:
  explicit JoyState(JoySettings settings);

  /// A device with so many axes and buttons; no button is pressed.
  void open(const std::vector<float>& raw_axes, std::size_t buttons);
  void close();
  /// Axes and buttons beyond those of `open` are ignored.
  JoyChange update(const std::vector<float>& raw_axes, const std::vector<int32_t>& raw_buttons);

  [[nodiscard]] const std::vector<float>& axes() const { return axes_; }
  [[nodiscard]] const std::vector<int32_t>& buttons() const { return buttons_; }

 private:
  bool move(std::size_t axis, float raw);
  bool press(std::size_t button, bool is_pressed);

  JoySettings settings_;
  std::vector<float> axes_;
  std::vector<int32_t> buttons_;
  /// The buttons of the device, on which none is sticky.
  std::vector<bool> pressed_;
};

}  // namespace joy
