// See file_tree.hpp.
#include "file_tree.hpp"

#include <errno.h>
#include <time.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <utility>

#include "ros2wasm/host.h"

namespace ros2wasm {
namespace {

constexpr size_t kLongestName = 255;
constexpr size_t kLongestPath = 4096;
constexpr uint32_t kFolderMode = 0755;
constexpr uint32_t kFileMode = 0644;
constexpr uint32_t kDeviceMode = 0666;
constexpr const char* kHome = "/home/user";

auto place_of(const File& folder, std::string_view name) {
  return std::lower_bound(
      folder->children.begin(), folder->children.end(), name,
      [](const File& one, std::string_view wanted) { return one->name < wanted; });
}

File child(const File& folder, std::string_view name) {
  const auto place = place_of(folder, name);
  return place != folder->children.end() && (*place)->name == name ? *place : nullptr;
}

uint32_t word_at(const std::string& text, size_t at) {
  uint32_t value = 0;
  std::memcpy(&value, text.data() + at, sizeof(value));
  return value;
}

}  // namespace

uint32_t usual_mode(FileKind kind) {
  switch (kind) {
    case FileKind::kFolder:
      return kFolderMode;
    case FileKind::kFile:
      return kFileMode;
    case FileKind::kNull:
    case FileKind::kConsole:
      break;
  }
  return kDeviceMode;
}

int64_t time_of_day_ns() {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  constexpr int64_t kSecond = 1000000000;
  return now.tv_sec * kSecond + now.tv_nsec;
}

FileTree::FileTree() : root_(std::make_shared<FileNode>()) {
  root_->kind = FileKind::kFolder;
  root_->mode = usual_mode(root_->kind);
  root_->changed_ns = time_of_day_ns();
  here = folder_at(kHome);
  folder_at("/tmp");
  const File devices = folder_at("/dev");
  add(devices, "null", FileKind::kNull);
  const char* const names[] = {"stdin", "stdout", "stderr"};
  for (int fd = 0; fd < 3; ++fd) {
    const File console = add(devices, names[fd], FileKind::kConsole);
    console->fd = fd;
    consoles[static_cast<size_t>(fd)] = console;
  }
  add_site_files();
}

/// u32 count, then each: u32 size, u32 length, path.
void FileTree::add_site_files() {
  std::string list(ros2wasm_file_list(nullptr, 0), '\0');
  ros2wasm_file_list(list.data(), list.size());
  if (list.empty()) {
    return;
  }
  size_t at = sizeof(uint32_t);
  for (uint32_t left = word_at(list, 0); left > 0; --left) {
    const uint32_t size = word_at(list, at);
    const uint32_t length = word_at(list, at + sizeof(uint32_t));
    at += 2 * sizeof(uint32_t);
    std::string path = list.substr(at, length);
    at += length;
    const size_t slash = path.rfind('/');
    const File folder = folder_at(std::string_view(path).substr(0, slash));
    const File file = add(folder, path.substr(slash + 1), FileKind::kFile);
    file->size_in_site = size;
    if (size > 0) {
      file->in_site = std::move(path);
    }
  }
}

File FileTree::add(const File& folder, std::string name, FileKind kind) {
  auto file = std::make_shared<FileNode>();
  file->kind = kind;
  file->mode = usual_mode(kind);
  file->parent = folder;
  file->number = ++last_number_;
  file->changed_ns = time_of_day_ns();
  const auto place = place_of(folder, name);
  file->name = std::move(name);
  folder->children.insert(place, file);
  folder->changed_ns = file->changed_ns;
  return file;
}

File FileTree::folder_at(std::string_view path) {
  File folder = root_;
  while (!path.empty()) {
    const size_t end = std::min(path.find('/'), path.size());
    if (end > 0) {
      File next = child(folder, path.substr(0, end));
      folder = next ? next : add(folder, std::string(path.substr(0, end)), FileKind::kFolder);
    }
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return folder;
}

Found FileTree::find(std::string_view path, const File& from) const {
  if (path.empty()) {
    return {ENOENT, nullptr, nullptr, {}};
  }
  if (path.size() >= kLongestPath) {
    return {ENAMETOOLONG, nullptr, nullptr, {}};
  }
  const bool wants_folder = path.back() == '/';
  Found found;
  found.file = path.front() == '/' ? root_ : from ? from : here;
  while (!path.empty()) {
    const size_t end = std::min(path.find('/'), path.size());
    const std::string_view name = path.substr(0, end);
    path.remove_prefix(std::min(end + 1, path.size()));
    if (name.empty()) {
      continue;
    }
    if (!found.file) {
      return {ENOENT, nullptr, nullptr, {}};
    }
    if (!found.file->is_folder()) {
      return {ENOTDIR, nullptr, nullptr, {}};
    }
    if (name.size() > kLongestName) {
      return {ENAMETOOLONG, nullptr, nullptr, {}};
    }
    if (name == ".") {
      continue;
    }
    if (name == "..") {
      if (const File parent = found.file->parent.lock()) {
        found.file = parent;
      }
      continue;
    }
    found.folder = found.file;
    found.name = name;
    found.file = child(found.folder, name);
  }
  if (!found.file) {
    found.error = ENOENT;
  } else if (wants_folder && !found.file->is_folder()) {
    return {ENOTDIR, nullptr, nullptr, {}};
  } else {
    found.folder = found.file->parent.lock();
    found.name = found.file->name;
  }
  return found;
}

File FileTree::make(const Found& found, FileKind kind) {
  return add(found.folder, found.name, kind);
}

void FileTree::remove(const Found& found) {
  if (!found.file->is_folder()) {
    found.file->parent.reset();
  }
  found.folder->children.erase(place_of(found.folder, found.name));
  found.folder->changed_ns = time_of_day_ns();
}

int FileTree::move(const Found& from, const Found& to) {
  if (from.file == to.file) {
    return 0;
  }
  for (File above = to.folder; above; above = above->parent.lock()) {
    if (above == from.file) {
      return EINVAL;
    }
  }
  if (to.file) {
    if (to.file->is_folder() != from.file->is_folder()) {
      return to.file->is_folder() ? EISDIR : ENOTDIR;
    }
    if (!to.file->children.empty()) {
      return ENOTEMPTY;
    }
  }
  std::string name = to.name;
  to.folder->children.reserve(to.folder->children.size() + 1);
  // From here on nothing asks for memory.
  if (to.file) {
    remove(to);
  }
  const File moved = from.file;
  remove(from);
  moved->name = std::move(name);
  moved->parent = to.folder;
  to.folder->children.insert(place_of(to.folder, to.name), moved);
  to.folder->changed_ns = time_of_day_ns();
  return 0;
}

int FileTree::load(FileNode& file) {
  if (file.in_site.empty()) {
    return 0;
  }
  std::string bytes;
  try {
    bytes.resize(file.size_in_site);
  } catch (const std::bad_alloc&) {
    return ENOMEM;
  }
  const std::string& path = file.in_site;
  const int32_t got = ros2wasm_file_read(path.data(), path.size(), bytes.data(), bytes.size());
  if (got < 0) {
    return EIO;
  }
  file.bytes = std::move(bytes);
  file.in_site.clear();
  return 0;
}

void FileTree::offer(FileNode& file, const std::string& path) {
  if (!file.written || file.parent.expired() || load(file) != 0) {
    return;
  }
  if (ros2wasm_file_closed(path.data(), path.size(), file.bytes.data(), file.bytes.size()) != 0) {
    file.written = false;
  }
}

void FileTree::offer_rest() const {
  offer_below(*root_, "", false);
}

void FileTree::offer_moved(const File& file) {
  offer_below(*file, path_of(file), true);
}

void FileTree::offer_below(FileNode& file, const std::string& path, bool moved) {
  if (file.kind == FileKind::kFile) {
    file.written = file.written || moved;
    offer(file, path);
  }
  for (const File& one : file.children) {
    offer_below(*one, path + "/" + one->name, moved);
  }
}

std::string FileTree::path_of(const File& file) {
  std::string path;
  for (File one = file; one && !one->name.empty(); one = one->parent.lock()) {
    path.insert(0, "/" + one->name);
  }
  return path.empty() ? "/" : path;
}

}  // namespace ros2wasm
