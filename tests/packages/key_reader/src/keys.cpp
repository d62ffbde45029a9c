// Reads keys in the three ways that do not wait for a line, and spins between them. Ends with x.

// Compatibility, works: keys without lines: terminal modes (`tcgetattr`, `tcsetattr` with VMIN and
// VTIME), `poll` and `select` on standard input; the page and `ros2 run` send each key at once

// Compatibility, differs: a terminal in raw mode -> Tab and the browser's own shortcuts stay the
// page's; `fcntl(O_NONBLOCK)` and `ioctl(FIONREAD)` are not there

#include <poll.h>
#include <sys/select.h>
#include <termios.h>
#include <unistd.h>

#include <cstdio>
#include <memory>

#include "rclcpp/rclcpp.hpp"

namespace {

bool something_by_select() {
  fd_set files;
  FD_ZERO(&files);
  FD_SET(STDIN_FILENO, &files);
  timeval soon{0, 1000};
  return select(STDIN_FILENO + 1, &files, nullptr, nullptr, &soon) == 1 &&
         FD_ISSET(STDIN_FILENO, &files);
}

bool something_by_poll() {
  pollfd file{STDIN_FILENO, POLLIN, 0};
  return poll(&file, 1, 0) == 1 && (file.revents & POLLIN) != 0;
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("keys");
  int ticks = 0;
  auto timer = node->create_wall_timer(std::chrono::milliseconds(1), [&ticks] { ++ticks; });
  termios before{};
  if (tcgetattr(STDIN_FILENO, &before) != 0 || tcgetattr(7, &before) == 0) return 1;
  termios raw = before;
  raw.c_lflag &= ~(ICANON | ECHO);
  raw.c_cc[VMIN] = 0;
  raw.c_cc[VTIME] = 1;
  if (tcsetattr(STDIN_FILENO, TCSANOW, &raw) != 0) return 1;
  char key = 0;
  std::printf("%s\n", something_by_select() || something_by_poll() ? "too early" : "no key yet");
  std::printf("read: %d\n", static_cast<int>(read(STDIN_FILENO, &key, 1)));
  std::fflush(stdout);
  rclcpp::spin_some(node);
  while (!something_by_poll() && rclcpp::ok()) {
    rclcpp::spin_some(node);
  }
  std::printf("ticks: %s, select: %d\n", ticks > 0 ? "some" : "none", something_by_select());
  while (key != 'x' && rclcpp::ok()) {
    if (read(STDIN_FILENO, &key, 1) == 1 && key != '\n') std::printf("key: %c\n", key);
  }
  tcsetattr(STDIN_FILENO, TCSANOW, &before);
  rclcpp::shutdown();
  return 0;
}
