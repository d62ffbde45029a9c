// See mapped_file.hpp.
#include "bundler/io/mapped_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "bundler/io/files.hpp"

namespace ros2wasm {

Outcome<FileIdentity> identity_of(const std::filesystem::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return cannot_read(path, errno);
  return FileIdentity{
      .size = static_cast<std::uint64_t>(status.st_size),
      .modified_ns = status.st_mtim.tv_sec * 1'000'000'000LL + status.st_mtim.tv_nsec,
      .inode = status.st_ino};
}

Outcome<MappedFile> MappedFile::open(const std::filesystem::path& path) {
  const auto opened = open_file_to_read(path);
  if (!opened) return opened.errors();
  const int file = *opened;
  MappedFile mapped;
  struct stat status {};
  int fault = ::fstat(file, &status) == 0 ? 0 : errno;
  if (fault == 0 && status.st_size > 0) {
    const auto size = static_cast<std::size_t>(status.st_size);
    void* data = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
    if (data == MAP_FAILED) {
      fault = errno;
    } else {
      mapped.data_ = static_cast<const char*>(data);
      mapped.size_ = size;
    }
  }
  ::close(file);
  if (fault != 0) return cannot_read(path, fault);
  return mapped;
}

MappedFile::~MappedFile() {
  if (data_ != nullptr) ::munmap(const_cast<char*>(data_), size_);  // NOLINT: munmap takes no const
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept {
  std::swap(data_, other.data_);
  std::swap(size_, other.size_);
  return *this;
}

}  // namespace ros2wasm
