// Gamepads as the page publishes them: /_gamepad/joystick_N and /_gamepad/controller_N, of type
// sensor_msgs/msg/Joy. Their axes have right and down positive; a message without axes and buttons
// means that the gamepad is gone. `frame_id` is `rumble NAME` or `still NAME`.
#pragma once

#include <optional>
#include <string>

namespace joy {

/// The page has no more.
inline constexpr int kMostDevices = 4;

struct GamepadDevice {
  std::string name;
  bool can_rumble = false;
};

/// Any node can publish on the topic; nullopt: the text has another form.
[[nodiscard]] std::optional<GamepadDevice> parse_device(const std::string& frame_id);

enum class GamepadLayout {
  kJoystick,    ///< the axes and buttons that Linux gives an Xbox gamepad, or those of the device
  kController,  ///< the 6 axes and 21 buttons of SDL's game controllers
};

[[nodiscard]] std::string device_topic(GamepadLayout layout, int device);

/// Its messages are sensor_msgs/msg/JoyFeedback; `id` is the number of the gamepad.
inline constexpr const char* kRumbleTopic = "/_gamepad/rumble";

}  // namespace joy
