// Keys of a terminal for programs that are driven by them. Not for programs of users: they use
// termios and poll themselves.
#pragma once

#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <optional>

namespace ros2wasm {

/// Keys one by one, without waiting for a line.
class Keyboard {
 public:
  Keyboard() {
    if (tcgetattr(STDIN_FILENO, &before_) != 0) return;
    is_terminal_ = true;
    termios raw = before_;
    raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    raw.c_cc[VMIN] = 1;
    raw.c_cc[VTIME] = 0;
    tcsetattr(STDIN_FILENO, TCSANOW, &raw);
  }
  ~Keyboard() {
    if (is_terminal_) tcsetattr(STDIN_FILENO, TCSANOW, &before_);
  }
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;

  /// Is there a key, or the end of the input? Waits for a moment.
  [[nodiscard]] static bool has_something() {
    constexpr int kMoment_ms = 10;
    pollfd input{STDIN_FILENO, POLLIN, 0};
    return poll(&input, 1, kMoment_ms) == 1;
  }
  /// Nothing at the end of the input.
  [[nodiscard]] static std::optional<char> key() {
    char key = 0;
    if (read(STDIN_FILENO, &key, 1) != 1) return std::nullopt;
    return key;
  }

 private:
  termios before_{};
  bool is_terminal_ = false;
};

}  // namespace ros2wasm
