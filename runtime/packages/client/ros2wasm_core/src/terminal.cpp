// Standard input as a terminal: its mode is kept here and told to the page, which sends lines or
// keys by it. A read that need not wait for a line asks the loader whether something was typed.
#include <errno.h>
#include <poll.h>
#include <sys/select.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ros2wasm/host.h"

namespace {

// WASI's poll_oneoff; compilers of different ages spell its structs differently.
enum Kind : uint8_t { kClock = 0, kRead = 1, kWrite = 2 };
struct Subscription {
  uint64_t index;
  Kind kind;
  union {
    uint32_t file;
    struct {
      uint32_t id;
      uint64_t timeout_ns;
      uint64_t precision_ns;
      uint16_t absolute;
    } clock;
  };
};
static_assert(sizeof(Subscription) == 48 && offsetof(Subscription, file) == 16);
struct Event {
  uint64_t index;
  uint16_t error;
  Kind kind;
  uint64_t size;
  uint16_t flags;
};
static_assert(sizeof(Event) == 32);

extern "C" __attribute__((import_module("wasi_snapshot_preview1"), import_name("poll_oneoff"))) int
ros2wasm_poll_oneoff(const Subscription* asked, Event* events, uint32_t count, uint32_t* told);

termios cooked() {
  termios mode{};
  mode.c_iflag = ICRNL | IXON;
  mode.c_oflag = OPOST | ONLCR;
  mode.c_cflag = CS8 | CREAD;
  mode.c_lflag = ISIG | ICANON | ECHO | ECHOE | ECHOK;
  mode.c_cc[VEOF] = 4;
  mode.c_cc[VMIN] = 1;
  return mode;
}

termios& terminal() {
  static termios mode = cooked();
  return mode;
}

bool is_terminal(int fd) {
  if (fd >= STDIN_FILENO && fd <= STDERR_FILENO) {
    return true;
  }
  errno = EBADF;
  return false;
}

}  // namespace

extern "C" {

int tcgetattr(int fd, termios* mode) {
  if (!is_terminal(fd)) {
    return -1;
  }
  *mode = terminal();
  return 0;
}

int tcsetattr(int fd, int, const termios* mode) {
  if (!is_terminal(fd)) {
    return -1;
  }
  terminal() = *mode;
  constexpr int kCooked = 0;
  constexpr int kCbreak = 1;
  constexpr int kRaw = 2;
  ros2wasm_terminal_mode((mode->c_lflag & ICANON) != 0 ? kCooked
                         : (mode->c_lflag & ISIG) != 0 ? kCbreak
                                                       : kRaw);
  return 0;
}

/// Supports the three standard files only; others cannot be open.
int poll(pollfd* files, nfds_t count, int timeout_ms) {
  std::vector<Subscription> asked;
  int ready = 0;
  const auto ask = [&](nfds_t index, Kind kind) {
    Subscription& one = asked.emplace_back();
    one.index = index;
    one.kind = kind;
    one.file = static_cast<uint32_t>(files[index].fd);
  };
  for (nfds_t i = 0; i < count; ++i) {
    files[i].revents = 0;
    if (files[i].fd > STDERR_FILENO) {
      files[i].revents = POLLNVAL;
      ++ready;
    } else if (files[i].fd == STDIN_FILENO && (files[i].events & POLLIN) != 0) {
      ask(i, kRead);
    } else if (files[i].fd > STDIN_FILENO && (files[i].events & POLLOUT) != 0) {
      ask(i, kWrite);
    }
  }
  if (ready > 0) {
    timeout_ms = 0;
  }
  if (timeout_ms >= 0 || asked.empty()) {
    constexpr uint64_t kMillisecond = 1000000;
    Subscription& one = asked.emplace_back();
    one.index = count;
    one.kind = kClock;
    one.clock = {1, timeout_ms < 0 ? INT64_MAX : timeout_ms * kMillisecond, 0, 0};
  }
  std::vector<Event> events(asked.size());
  uint32_t told = 0;
  const int error = ros2wasm_poll_oneoff(asked.data(), events.data(), asked.size(), &told);
  for (uint32_t i = 0; i < told && error == 0; ++i) {
    if (events[i].index < count) {
      files[events[i].index].revents |= events[i].kind == kRead ? POLLIN : POLLOUT;
      ++ready;
    }
  }
  if (error != 0 || (told == 0 && ready == 0)) {
    errno = error != 0 ? EINVAL : EINTR;
    return -1;
  }
  return ready;
}

int select(int limit, fd_set* reading, fd_set* writing, fd_set* failing, timeval* timeout) {
  std::vector<pollfd> files;
  for (int fd = 0; fd < limit; ++fd) {
    const bool reads = reading != nullptr && FD_ISSET(fd, reading);
    const bool writes = writing != nullptr && FD_ISSET(fd, writing);
    if (reads || writes) {
      files.push_back({fd, static_cast<short>((reads ? POLLIN : 0) | (writes ? POLLOUT : 0)), 0});
    }
  }
  // Rounded up, so that who waits for a moment does not spin.
  const int timeout_ms =
      timeout == nullptr
          ? -1
          : static_cast<int>(timeout->tv_sec * 1000 + (timeout->tv_usec + 999) / 1000);
  if (poll(files.data(), files.size(), timeout_ms) < 0) {
    return -1;
  }
  int ready = 0;
  for (const pollfd& file : files) {
    if ((file.revents & POLLNVAL) != 0) {
      errno = EBADF;
      return -1;
    }
    const auto answer = [&](fd_set* set, int event) {
      if (set == nullptr || !FD_ISSET(file.fd, set)) {
        return;
      }
      if ((file.revents & event) != 0) {
        ++ready;
      } else {
        FD_CLR(file.fd, set);
      }
    };
    answer(reading, POLLIN);
    answer(writing, POLLOUT);
  }
  if (failing != nullptr) {
    FD_ZERO(failing);
  }
  return ready;
}

ssize_t __real_read(int fd, void* buffer, size_t size);

/// A terminal without lines and without a least number of bytes gives up after its own time. The
/// Enter key comes as a line's end, which it is only where ICRNL says so.
ssize_t __wrap_read(int fd, void* buffer, size_t size) {
  const termios& mode = terminal();
  if (fd != STDIN_FILENO || (mode.c_lflag & ICANON) != 0) {
    return __real_read(fd, buffer, size);
  }
  if (mode.c_cc[VMIN] == 0) {
    constexpr int kTenth = 100;
    pollfd input{STDIN_FILENO, POLLIN, 0};
    const int ready = poll(&input, 1, mode.c_cc[VTIME] * kTenth);
    if (ready <= 0) {
      return ready;
    }
  }
  const ssize_t length = __real_read(fd, buffer, size);
  if (length > 0 && (mode.c_iflag & ICRNL) == 0) {
    char* const begin = static_cast<char*>(buffer);
    std::replace(begin, begin + length, '\n', '\r');
  }
  return length;
}

}  // extern "C"
