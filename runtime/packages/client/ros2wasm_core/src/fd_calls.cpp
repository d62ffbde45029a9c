// The C library's calls for descriptors of files: reading, writing, seeking and closing come back
// through the loader (WASI), which keeps descriptors 0 to 2 and hands on others.
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <string.h>
#include <unistd.h>

#include <mutex>
#include <new>
#include <utility>

#include "open_files.hpp"

namespace ros2wasm {

Files& files() {
  static Files* const all = new Files();
  return *all;
}

long resize(FileNode& file, int64_t size) {
  if (size < 0 || file.kind != FileKind::kFile) {
    return -EINVAL;
  }
  if (size > kLargestFile) {
    return -EFBIG;
  }
  if (const int error = FileTree::load(file)) {
    return -error;
  }
  try {
    file.bytes.resize(static_cast<size_t>(size));
  } catch (const std::bad_alloc&) {
    return -ENOSPC;
  }
  file.written = true;
  file.changed_ns = time_of_day_ns();
  return 0;
}

}  // namespace ros2wasm

namespace {

using ros2wasm::File;
using ros2wasm::FileKind;
using ros2wasm::files;
using ros2wasm::Files;
using ros2wasm::FileTree;
using ros2wasm::kLargestFile;
using ros2wasm::Lock;
using ros2wasm::OpenFile;
using ros2wasm::resize;
using ros2wasm::whole;

struct Vector {
  uint8_t* bytes;
  uint32_t length;
};

/// errno of WASI. Those that the loader gets.
enum Wasi : int {
  kSuccess = 0,
  kBadFile = 8,
  kInvalid = 28,
  kIo = 29,
  kIsFolder = 31,
  kNoSpace = 51
};

}  // namespace

extern "C" {

// The WASI calls that the loader forwards. They return 0, or an errno of WASI.

int ros2wasm_fd_read(int fd, const Vector* vectors, uint32_t count, uint32_t* out) {
  Files& all = files();
  const Lock lock(all.mutex);
  OpenFile* const open = all.at(fd);
  if (open == nullptr || (open->flags & O_ACCMODE) == O_WRONLY) {
    return kBadFile;
  }
  if (open->file->is_folder()) {
    return kIsFolder;
  }
  if (FileTree::load(*open->file) != 0) {
    return kIo;
  }
  const std::string& bytes = open->file->bytes;
  *out = 0;
  for (uint32_t i = 0; i < count && open->position < static_cast<int64_t>(bytes.size()); ++i) {
    const size_t at = static_cast<size_t>(open->position);
    const size_t length =
        bytes.copy(reinterpret_cast<char*>(vectors[i].bytes), vectors[i].length, at);
    open->position += static_cast<int64_t>(length);
    *out += length;
  }
  return kSuccess;
}

int ros2wasm_fd_write(int fd, const Vector* vectors, uint32_t count, uint32_t* out) {
  Files& all = files();
  const Lock lock(all.mutex);
  OpenFile* const open = all.at(fd);
  if (open == nullptr || (open->flags & O_ACCMODE) == O_RDONLY) {
    return kBadFile;
  }
  ros2wasm::FileNode& file = *open->file;
  int64_t length = 0;
  for (uint32_t i = 0; i < count; ++i) {
    length += vectors[i].length;
  }
  *out = static_cast<uint32_t>(length);
  if (file.kind == FileKind::kNull || length == 0) {
    return kSuccess;
  }
  if (FileTree::load(file) != 0) {
    return kIo;
  }
  if ((open->flags & O_APPEND) != 0) {
    open->position = static_cast<int64_t>(file.bytes.size());
  }
  const int64_t end = open->position + length;
  if (end > static_cast<int64_t>(file.bytes.size()) && resize(file, end) != 0) {
    return kNoSpace;
  }
  for (uint32_t i = 0; i < count; ++i) {
    memcpy(file.bytes.data() + open->position, vectors[i].bytes, vectors[i].length);
    open->position += vectors[i].length;
  }
  file.written = true;
  file.changed_ns = ros2wasm::time_of_day_ns();
  return kSuccess;
}

/// The offset comes in two halves, so that no caller needs 64-bit parameters.
int ros2wasm_fd_seek(int fd, uint32_t low, int32_t high, int whence, int64_t* out) {
  Files& all = files();
  const Lock lock(all.mutex);
  OpenFile* const open = all.at(fd);
  if (open == nullptr) {
    return kBadFile;
  }
  const int64_t base = whence == SEEK_SET   ? 0
                       : whence == SEEK_CUR ? open->position
                       : whence == SEEK_END ? static_cast<int64_t>(open->file->size())
                                            : -1;
  int64_t wanted = 0;
  const bool fits = !__builtin_add_overflow(base, whole(static_cast<long>(low), high), &wanted);
  if (base < 0 || !fits || wanted < 0 || wanted > kLargestFile) {
    return kInvalid;
  }
  open->position = wanted;
  *out = wanted;
  return kSuccess;
}

int ros2wasm_fd_close(int fd) {
  Files& all = files();
  const Lock lock(all.mutex);
  OpenFile* const open = all.at(fd);
  if (open == nullptr) {
    return kBadFile;
  }
  const File file = std::move(open->file);
  *open = {};
  try {
    if (file->written) {
      FileTree::offer(*file, FileTree::path_of(file));
    }
  } catch (const std::bad_alloc&) {
    // There is no room for its path: it is offered again at the end.
  }
  return kSuccess;
}

/// At the program's end. Who does not wait may have a thread that ended with the files in its
/// hands.
void ros2wasm_files_rest(int waits) {
  Files& all = files();
  std::unique_lock<std::mutex> lock(all.mutex, std::defer_lock);
  if (waits != 0) {
    lock.lock();
  } else if (!lock.try_lock()) {
    return;
  }
  try {
    all.tree.offer_rest();
  } catch (const std::bad_alloc&) {
    // No memory for the path of a file: the rest of the files are not offered.
  }
}

int ros2wasm_fd_is_open(int fd) {
  Files& all = files();
  const Lock lock(all.mutex);
  return all.at(fd) != nullptr ? kSuccess : kBadFile;
}

}  // extern "C"
