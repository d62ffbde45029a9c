// See file_lock.hpp.
#include "bundler/io/file_lock.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "bundler/io/files.hpp"

namespace ros2wasm {

namespace {

/// Waits for other processes. 0, or the reason why there is no lock; ECANCELED when the program
/// should end.
int wait_for_lock(int fd, int kind, const Cancellation& cancellation) {
  while (::flock(fd, kind | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK && errno != EINTR) return errno;
    if (cancellation.requested()) return ECANCELED;
    constexpr int kPatienceMs = 50;
    pollfd wake{.fd = cancellation.wake_fd(), .events = POLLIN, .revents = 0};
    ::poll(&wake, 1, kPatienceMs);
  }
  return 0;
}

}  // namespace

Outcome<FileLock> FileLock::take(const std::filesystem::path& file,
                                 const Cancellation& cancellation) {
  if (auto made = make_directories(file.parent_path()); !made) return std::move(made).errors();
  const int fd = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (fd < 0) return cannot_write(file, errno);
  FileLock lock(fd);
  const int fault = wait_for_lock(fd, LOCK_EX, cancellation);
  if (fault == ECANCELED) return interrupted();
  if (fault != 0) return cannot_write(file, fault);
  return lock;
}

Outcome<std::optional<FileLock>> FileLock::take_folder(const std::filesystem::path& folder,
                                                       bool is_shared,
                                                       const Cancellation& cancellation) {
  FileLock lock(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (lock.fd_ < 0) return cannot_read(folder, errno);
  const int fault = wait_for_lock(lock.fd_, is_shared ? LOCK_SH : LOCK_EX, cancellation);
  if (fault == ECANCELED) return interrupted();
  if (fault != 0) return std::optional<FileLock>();
  return std::optional<FileLock>(std::move(lock));
}

std::optional<FileLock> FileLock::of_folder(const std::filesystem::path& folder, bool is_shared) {
  FileLock lock(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  const int kind = is_shared ? LOCK_SH : LOCK_EX;
  if (lock.fd_ < 0 || ::flock(lock.fd_, kind | LOCK_NB) != 0) return std::nullopt;
  return lock;
}

std::optional<FileLock> FileLock::try_take(const std::filesystem::path& file) {
  FileLock lock(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
  if (lock.fd_ < 0 || ::flock(lock.fd_, LOCK_EX | LOCK_NB) != 0) return std::nullopt;
  return lock;
}

FileLock::FileLock(FileLock&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  std::swap(fd_, other.fd_);
  return *this;
}

FileLock::~FileLock() {
  if (fd_ >= 0) ::close(fd_);
}

}  // namespace ros2wasm
