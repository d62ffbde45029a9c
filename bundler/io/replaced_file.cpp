// See replaced_file.hpp.
#include "bundler/io/replaced_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

#include "bundler/io/files.hpp"

namespace ros2wasm {

Outcome<ReplacedFile> ReplacedFile::begin(const std::filesystem::path& path) {
  if (path.has_parent_path()) {
    if (auto made = make_directories(path.parent_path()); !made) return std::move(made).errors();
  }
  ReplacedFile writer(path);
  // A name may be as long as a file system allows; the temporary one must not be longer.
  constexpr std::string_view kRandom = ".XXXXXX";
  const std::string name = path.filename().string().substr(0, kLongestName - kRandom.size());
  std::string pattern = (path.parent_path() / (name + std::string(kRandom))).string();
  writer.file_ = ::mkostemp(pattern.data(), O_CLOEXEC);
  if (writer.file_ < 0) return cannot_write(path, errno);
  writer.beside_ = pattern;
  if (::fchmod(writer.file_, 0644) != 0) return cannot_write(path, errno);
  return writer;
}

ReplacedFile::~ReplacedFile() {
  if (file_ >= 0) ::close(file_);
  if (!beside_.empty()) ::unlink(beside_.c_str());
}

ReplacedFile::ReplacedFile(ReplacedFile&& other) noexcept
    : path_(std::move(other.path_)),
      beside_(std::exchange(other.beside_, {})),
      file_(std::exchange(other.file_, -1)) {}

ReplacedFile& ReplacedFile::operator=(ReplacedFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(beside_, other.beside_);
  std::swap(file_, other.file_);
  return *this;
}

Outcome<Done> ReplacedFile::append(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return cannot_write(path_, errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return Done{};
}

Outcome<Done> ReplacedFile::overwrite_front(std::string_view bytes) {
  off_t at = 0;
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(file_, bytes.data(), bytes.size(), at);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return cannot_write(path_, errno);
    at += written;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return Done{};
}

Outcome<Done> ReplacedFile::finish() {
  const int fault = ::close(std::exchange(file_, -1)) == 0 ? 0 : errno;
  if (fault != 0) return cannot_write(path_, fault);
  std::error_code error;
  std::filesystem::rename(beside_, path_, error);
  if (error) return cannot_write(path_, error.value());
  beside_.clear();
  return Done{};
}

}  // namespace ros2wasm
