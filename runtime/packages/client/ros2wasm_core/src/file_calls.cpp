// The C library's calls for paths and folders, on file_tree.hpp.
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdint.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <mutex>
#include <new>
#include <vector>

#include "open_files.hpp"

namespace {

using ros2wasm::File;
using ros2wasm::FileKind;
using ros2wasm::files;
using ros2wasm::Files;
using ros2wasm::FileTree;
using ros2wasm::Found;
using ros2wasm::kFirst;
using ros2wasm::Lock;
using ros2wasm::OpenFile;
using ros2wasm::resize;
using ros2wasm::whole;

constexpr int kMostOpen = 1024;
constexpr uint32_t kBlock = 4096;

const char* text(long address) {
  return reinterpret_cast<const char*>(address);
}

/// The file of a descriptor; null: it is not open.
File file_of(Files& all, long fd) {
  if (fd >= 0 && fd < kFirst) {
    return all.tree.consoles[static_cast<size_t>(fd)];
  }
  const OpenFile* const open = all.at(static_cast<int>(fd));
  return open == nullptr ? nullptr : open->file;
}

Found find(Files& all, long folder, long path) {
  File from;
  if (folder != AT_FDCWD && *text(path) != '/') {
    from = file_of(all, folder);
    if (!from) {
      return {EBADF, nullptr, nullptr, {}};
    }
  }
  try {
    return all.tree.find(text(path), from);
  } catch (const std::bad_alloc&) {
    return {ENOMEM, nullptr, nullptr, {}};
  }
}

/// Runs an action that needs memory; returns -ENOMEM where there is none.
template <typename Action>
long within_memory(Action action) {
  try {
    return action();
  } catch (const std::bad_alloc&) {
    return -ENOMEM;
  }
}

constexpr uint32_t kModeBits = 07777;
constexpr uint32_t kMask = 022;  ///< umask, which nobody changes

/// Index of a place in `open`, which is there from now on; kMostOpen: there is none.
long free_place(Files& all) {
  const auto found =
      std::find_if(all.open.begin(), all.open.end(), [](const OpenFile& one) { return !one.file; });
  const long index = found - all.open.begin();
  if (found == all.open.end() && index < kMostOpen) {
    all.open.emplace_back();
  }
  return index;
}

/// `mode`: of a file that is made. Nothing is made or emptied by a call that fails.
long open_file(long folder, long path, long flags, uint32_t mode) {
  Files& all = files();
  const Lock lock(all.mutex);
  const long index = free_place(all);
  if (index >= kMostOpen) {
    return -EMFILE;
  }
  Found found = find(all, folder, path);
  const bool writes = (flags & O_ACCMODE) != O_RDONLY;
  if (found.file && (flags & O_CREAT) != 0 && (flags & O_EXCL) != 0) {
    return -EEXIST;
  }
  if (!found.file) {
    if (found.error != ENOENT || !found.folder || (flags & O_CREAT) == 0) {
      return -found.error;
    }
    if (text(path)[strlen(text(path)) - 1] == '/') {
      return -EISDIR;
    }
    if ((flags & O_DIRECTORY) != 0) {
      return -EINVAL;
    }
    found.file = all.tree.make(found, FileKind::kFile);
    found.file->mode = mode & kModeBits & ~kMask;
  }
  const File file = found.file;
  if (file->kind == FileKind::kConsole) {
    return file->fd;
  }
  if (file->is_folder() && (writes || (flags & O_CREAT) != 0)) {
    return -EISDIR;
  }
  if (!file->is_folder() && (flags & O_DIRECTORY) != 0) {
    return -ENOTDIR;
  }
  if ((flags & O_TRUNC) != 0 && writes) {
    file->written = file->written || file->size() > 0;
    file->in_site.clear();
    file->bytes.clear();
    file->changed_ns = ros2wasm::time_of_day_ns();
  }
  all.open[static_cast<size_t>(index)] = {file, 0, static_cast<int>(flags), {}};
  return kFirst + index;
}

mode_t mode_of(const ros2wasm::FileNode& file) {
  const mode_t kind = file.is_folder() ? S_IFDIR : file.kind == FileKind::kFile ? S_IFREG : S_IFCHR;
  return kind | file.mode;
}

long describe(const ros2wasm::FileNode& file, long out) {
  struct stat told {};
  constexpr int64_t kSecond = 1000000000;
  told.st_mode = mode_of(file);
  told.st_nlink = 1;
  told.st_ino = file.number;
  told.st_size = file.is_folder() ? kBlock : static_cast<off_t>(file.size());
  told.st_blksize = kBlock;
  told.st_blocks = (told.st_size + 511) / 512;
  told.st_mtim.tv_sec = file.changed_ns / kSecond;
  told.st_mtim.tv_nsec = static_cast<long>(file.changed_ns % kSecond);
  told.st_atim = told.st_ctim = told.st_mtim;
  *reinterpret_cast<struct stat*>(out) = told;
  return 0;
}

long describe_path(long folder, long path, long out) {
  Files& all = files();
  const Lock lock(all.mutex);
  const Found found = find(all, folder, path);
  return found.error != 0 ? -found.error : describe(*found.file, out);
}

long make_folder(long folder, long path, long mode) {
  Files& all = files();
  const Lock lock(all.mutex);
  const Found found = find(all, folder, path);
  if (found.file) {
    return -EEXIST;
  }
  if (found.error != ENOENT || !found.folder) {
    return -found.error;
  }
  all.tree.make(found, FileKind::kFolder)->mode = static_cast<uint32_t>(mode) & kModeBits & ~kMask;
  return 0;
}

long remove_path(long folder, long path, bool is_folder) {
  Files& all = files();
  const Lock lock(all.mutex);
  const Found found = find(all, folder, path);
  if (found.error != 0) {
    return -found.error;
  }
  if (found.file->is_folder() != is_folder) {
    return is_folder ? -ENOTDIR : -EISDIR;
  }
  if (!found.file->children.empty()) {
    return -ENOTEMPTY;
  }
  if (!found.folder) {
    return -EBUSY;
  }
  all.tree.remove(found);
  return 0;
}

long rename_path(long from_folder, long from, long to_folder, long to) {
  Files& all = files();
  const Lock lock(all.mutex);
  const Found old = find(all, from_folder, from);
  if (old.error != 0) {
    return -old.error;
  }
  const Found place = find(all, to_folder, to);
  if (!place.folder || !old.folder) {
    return place.error != 0 ? -place.error : -EBUSY;
  }
  const int error = all.tree.move(old, place);
  if (error == 0) {
    FileTree::offer_moved(old.file);
  }
  return -error;
}

long access_path(long folder, long path) {
  Files& all = files();
  const Lock lock(all.mutex);
  return -find(all, folder, path).error;
}

/// There are no symbolic links: a file is none, and others are missing.
long link_target(long folder, long path) {
  const long error = access_path(folder, path);
  return error != 0 ? error : -EINVAL;
}

long change_mode(long folder, long path, long mode) {
  Files& all = files();
  const Lock lock(all.mutex);
  const Found found = find(all, folder, path);
  if (found.error == 0) {
    found.file->mode = static_cast<uint32_t>(mode) & kModeBits;
  }
  return -found.error;
}

/// `times`: of the last access, which nobody keeps, and of the last change; null: now.
long change_time(ros2wasm::FileNode& file, long times) {
  constexpr int64_t kSecond = 1000000000;
  const auto* const told = reinterpret_cast<const timespec*>(times);
  if (told == nullptr || told[1].tv_nsec == UTIME_NOW) {
    file.changed_ns = ros2wasm::time_of_day_ns();
  } else if (told[1].tv_nsec != UTIME_OMIT) {
    if (told[1].tv_nsec < 0 || told[1].tv_nsec >= kSecond) {
      return -EINVAL;
    }
    file.changed_ns = told[1].tv_sec * kSecond + told[1].tv_nsec;
  }
  return 0;
}

/// Bytes of the path with its end.
long tell_here(long buffer, long size) {
  Files& all = files();
  const Lock lock(all.mutex);
  const std::string path = FileTree::path_of(all.tree.here);
  if (static_cast<size_t>(size) <= path.size()) {
    return -ERANGE;
  }
  memcpy(reinterpret_cast<char*>(buffer), path.c_str(), path.size() + 1);
  return static_cast<long>(path.size() + 1);
}

/// Bytes of the entries that fit.
long list_folder(long fd, long buffer, long size) {
  Files& all = files();
  const Lock lock(all.mutex);
  OpenFile* const open = all.at(static_cast<int>(fd));
  if (open == nullptr) {
    return -EBADF;
  }
  if (!open->file->is_folder()) {
    return -ENOTDIR;
  }
  constexpr int64_t kDots = 2;
  const auto& children = open->file->children;
  if (open->position <= kDots) {
    open->last_told.clear();
  }
  auto next =
      std::upper_bound(children.begin(), children.end(), open->last_told,
                       [](const std::string& last, const File& one) { return last < one->name; });
  long used = 0;
  while (used + static_cast<long>(sizeof(dirent)) <= size) {
    const bool dots = open->position < kDots;
    if (!dots && next == children.end()) {
      break;
    }
    const ros2wasm::FileNode& file = dots ? *open->file : **next;
    const std::string name = !dots ? file.name : open->position == 0 ? "." : "..";
    if (!dots) {
      open->last_told = name;
      ++next;
    }
    dirent told{};
    told.d_ino = file.number;
    told.d_off = ++open->position;
    told.d_reclen = sizeof(dirent);
    told.d_type = file.is_folder() ? DT_DIR : file.kind == FileKind::kFile ? DT_REG : DT_CHR;
    name.copy(told.d_name, sizeof(told.d_name) - 1);
    memcpy(reinterpret_cast<void*>(buffer + used), &told, sizeof(told));
    used += static_cast<long>(sizeof(told));
  }
  return used;
}

}  // namespace

extern "C" {

// NOLINTBEGIN(bugprone-reserved-identifier, cert-dcl50-cpp): the C library's own names
long __syscall_open(long path, long flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const uint32_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  return within_memory([&] { return open_file(AT_FDCWD, path, flags, mode); });
}
long __syscall_openat(long folder, long path, long flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const uint32_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  return within_memory([&] { return open_file(folder, path, flags, mode); });
}
/// The console is a terminal of the usual size, files are none. Weak: programs without threads have
/// one of Emscripten's.
__attribute__((weak)) long __syscall_ioctl(long fd, long request, ...) {
  Files& all = files();
  const Lock lock(all.mutex);
  const File file = file_of(all, fd);
  if (!file) {
    return -EBADF;
  }
  if (file->kind != FileKind::kConsole || request != TIOCGWINSZ) {
    return -ENOTTY;
  }
  va_list rest;
  va_start(rest, request);
  *va_arg(rest, winsize*) = {24, 80, 0, 0};
  va_end(rest);
  return 0;
}
long __syscall_stat64(long path, long out) {
  return describe_path(AT_FDCWD, path, out);
}
long __syscall_lstat64(long path, long out) {
  return describe_path(AT_FDCWD, path, out);
}
long __syscall_fstatat64(long folder, long path, long out, long flags) {
  if ((flags & AT_EMPTY_PATH) != 0 && *text(path) == '\0') {
    path = reinterpret_cast<long>(".");
  }
  return describe_path(folder, path, out);
}
long __syscall_fstat64(long fd, long out) {
  Files& all = files();
  const Lock lock(all.mutex);
  const File file = file_of(all, fd);
  return !file ? -EBADF : describe(*file, out);
}
long __syscall_access(long path, long) {
  return access_path(AT_FDCWD, path);
}
long __syscall_faccessat(long folder, long path, long, long) {
  return access_path(folder, path);
}
long __syscall_mkdir(long path, long mode) {
  return within_memory([&] { return make_folder(AT_FDCWD, path, mode); });
}
long __syscall_mkdirat(long folder, long path, long mode) {
  return within_memory([&] { return make_folder(folder, path, mode); });
}
long __syscall_rmdir(long path) {
  return remove_path(AT_FDCWD, path, true);
}
long __syscall_unlink(long path) {
  return remove_path(AT_FDCWD, path, false);
}
long __syscall_unlinkat(long folder, long path, long flags) {
  return remove_path(folder, path, (flags & AT_REMOVEDIR) != 0);
}
long __syscall_rename(long from, long to) {
  return within_memory([&] { return rename_path(AT_FDCWD, from, AT_FDCWD, to); });
}
long __syscall_renameat(long from_folder, long from, long to_folder, long to) {
  return within_memory([&] { return rename_path(from_folder, from, to_folder, to); });
}
long __syscall_readlink(long path, long, long) {
  return link_target(AT_FDCWD, path);
}
long __syscall_readlinkat(long folder, long path, long, long) {
  return link_target(folder, path);
}
long __syscall_truncate64(long path, long low, long high) {
  Files& all = files();
  const Lock lock(all.mutex);
  const Found found = find(all, AT_FDCWD, path);
  return found.error != 0 ? -found.error : resize(*found.file, whole(low, high));
}
long __syscall_ftruncate64(long fd, long low, long high) {
  Files& all = files();
  const Lock lock(all.mutex);
  const File file = file_of(all, fd);
  return !file ? -EBADF : resize(*file, whole(low, high));
}
/// Everybody may do everything, whatever the mode.
long __syscall_chmod(long path, long mode) {
  return change_mode(AT_FDCWD, path, mode);
}
long __syscall_fchmodat(long folder, long path, long mode, ...) {
  return change_mode(folder, path, mode);
}
long __syscall_fchmod(long fd, long mode) {
  Files& all = files();
  const Lock lock(all.mutex);
  const File file = file_of(all, fd);
  if (!file) {
    return -EBADF;
  }
  file->mode = static_cast<uint32_t>(mode) & kModeBits;
  return 0;
}
/// Without a path: of the open file.
long __syscall_utimensat(long folder, long path, long times, long) {
  Files& all = files();
  const Lock lock(all.mutex);
  if (path == 0) {
    const File file = file_of(all, folder);
    return !file ? -EBADF : change_time(*file, times);
  }
  const Found found = find(all, folder, path);
  return found.error != 0 ? -found.error : change_time(*found.file, times);
}
long __syscall_chdir(long path) {
  Files& all = files();
  const Lock lock(all.mutex);
  const Found found = find(all, AT_FDCWD, path);
  if (found.error != 0) {
    return -found.error;
  }
  if (!found.file->is_folder()) {
    return -ENOTDIR;
  }
  all.tree.here = found.file;
  return 0;
}
long __syscall_getcwd(long buffer, long size) {
  return within_memory([&] { return tell_here(buffer, size); });
}
long __syscall_getdents64(long fd, long buffer, long size) {
  return within_memory([&] { return list_folder(fd, buffer, size); });
}
// NOLINTEND(bugprone-reserved-identifier, cert-dcl50-cpp)

}  // extern "C"
