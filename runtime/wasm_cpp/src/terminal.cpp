// Standard input as a terminal: its mode is kept here, and a read that need not wait for a line
// asks the loader whether something was typed. What is typed comes line by line, whatever the mode.
#include <errno.h>
#include <poll.h>
#include <sys/select.h>
#include <termios.h>
#include <unistd.h>
#include <wasi/api.h>

#include <algorithm>
#include <vector>

namespace {

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
  return 0;
}

/// Of the three standard files only; others cannot be open.
int poll(pollfd* files, nfds_t count, int timeout_ms) {
  std::vector<__wasi_subscription_t> asked;
  int ready = 0;
  for (nfds_t i = 0; i < count; ++i) {
    files[i].revents = 0;
    __wasi_subscription_t one{};
    one.userdata = i;
    one.u.u.fd_read.file_descriptor = static_cast<__wasi_fd_t>(files[i].fd);
    if (files[i].fd > STDERR_FILENO) {
      files[i].revents = POLLNVAL;
      ++ready;
    } else if (files[i].fd == STDIN_FILENO && (files[i].events & POLLIN) != 0) {
      one.u.tag = __WASI_EVENTTYPE_FD_READ;
      asked.push_back(one);
    } else if (files[i].fd > STDIN_FILENO && (files[i].events & POLLOUT) != 0) {
      one.u.tag = __WASI_EVENTTYPE_FD_WRITE;
      asked.push_back(one);
    }
  }
  if (timeout_ms >= 0 || ready > 0 || asked.empty()) {
    __wasi_subscription_t clock{};
    clock.userdata = count;
    clock.u.tag = __WASI_EVENTTYPE_CLOCK;
    clock.u.u.clock.id = __WASI_CLOCKID_MONOTONIC;
    // Without a file and a timeout it waits for a signal, which never comes.
    constexpr __wasi_timestamp_t kMillisecond = 1000000;
    clock.u.u.clock.timeout = ready > 0 ? 0
                              : timeout_ms < 0
                                  ? INT64_MAX
                                  : static_cast<__wasi_timestamp_t>(timeout_ms) * kMillisecond;
    asked.push_back(clock);
  }
  std::vector<__wasi_event_t> events(asked.size());
  __wasi_size_t told = 0;
  if (__wasi_poll_oneoff(asked.data(), events.data(), asked.size(), &told) != 0) {
    errno = EINVAL;
    return -1;
  }
  for (__wasi_size_t i = 0; i < told; ++i) {
    if (events[i].userdata < count) {
      files[events[i].userdata].revents |=
          events[i].type == __WASI_EVENTTYPE_FD_READ ? POLLIN : POLLOUT;
      ++ready;
    }
  }
  if (told == 0 && ready == 0) {
    errno = EINTR;
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

/// A terminal without lines and without a least number of bytes gives up after its own time.
ssize_t __wrap_read(int fd, void* buffer, size_t size) {
  const termios& mode = terminal();
  if (fd == STDIN_FILENO && (mode.c_lflag & ICANON) == 0 && mode.c_cc[VMIN] == 0) {
    constexpr int kTenth = 100;
    pollfd input{STDIN_FILENO, POLLIN, 0};
    const int ready = poll(&input, 1, mode.c_cc[VTIME] * kTenth);
    if (ready <= 0) {
      return ready;
    }
  }
  return __real_read(fd, buffer, size);
}

}  // extern "C"
