// See part_file.hpp.
#include "bundler/io/part_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <utility>

#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace {

/// The name still leads to the file that was opened: nobody gave it its place in between.
bool still_named(int fd, const std::string& path) {
  struct stat opened {};
  struct stat named {};
  return ::fstat(fd, &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

}  // namespace

Outcome<PartFile> PartFile::open(const std::filesystem::path& place) {
  if (auto made = make_directories(place.parent_path()); !made) return std::move(made).errors();
  const std::string path = place.string() + ".part";
  const int fd = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (fd < 0) return cannot_write(path, errno);
  if (::flock(fd, LOCK_EX | LOCK_NB) == 0 && still_named(fd, path)) return PartFile(path, fd);
  ::close(fd);
  std::string own = path + ".XXXXXX";
  const int other = ::mkostemp(own.data(), O_CLOEXEC);
  if (other < 0) return cannot_write(own, errno);
  ::close(other);
  return PartFile(own, -1);
}

PartFile::~PartFile() {
  std::error_code ignored;
  const bool of_use = fd_ >= 0 && std::filesystem::file_size(path_, ignored) != 0;
  // While the lock is held: who opens the file meanwhile sees that its name has gone.
  if (!path_.empty() && !of_use) std::filesystem::remove(path_, ignored);
  if (fd_ >= 0) ::close(fd_);
}

PartFile::PartFile(PartFile&& other) noexcept
    : path_(std::exchange(other.path_, {})), fd_(std::exchange(other.fd_, -1)) {}

PartFile& PartFile::operator=(PartFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(fd_, other.fd_);
  return *this;
}

Outcome<Done> PartFile::finish(const std::filesystem::path& place) {
  std::error_code error;
  std::filesystem::rename(path_, place, error);
  if (error) return cannot_write(place, error.value());
  path_.clear();
  return Done{};
}

}  // namespace ros2wasm
