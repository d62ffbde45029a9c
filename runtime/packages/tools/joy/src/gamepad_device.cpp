// See gamepad_device.hpp.
#include "gamepad_device.hpp"

namespace joy {

std::optional<GamepadDevice> parse_device(const std::string& frame_id) {
  const std::size_t blank = frame_id.find(' ');
  if (blank == std::string::npos) return std::nullopt;
  const std::string kind = frame_id.substr(0, blank);
  if (kind != "rumble" && kind != "still") return std::nullopt;
  return GamepadDevice{frame_id.substr(blank + 1), kind == "rumble"};
}

std::string device_topic(GamepadLayout layout, int device) {
  const char* kind = layout == GamepadLayout::kJoystick ? "joystick" : "controller";
  return std::string("/_gamepad/") + kind + "_" + std::to_string(device);
}

}  // namespace joy
