// Files and folders: those of the program's file tree.
#include "rcutils/filesystem.h"

#include <dirent.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "rcutils/env.h"
#include "rcutils/error_handling.h"
#include "rcutils/strdup.h"

namespace {

bool read_status(const char* path, struct stat& status) {
  return path != nullptr && stat(path, &status) == 0;
}

char* copy(const std::string& text, const rcutils_allocator_t& allocator) {
  return rcutils_strndup(text.data(), text.size(), allocator);
}

// `depth` levels below the folder itself; 0: all.
rcutils_ret_t add_sizes(const std::string& folder, size_t depth, bool limited, uint64_t& size) {
  DIR* const entries = opendir(folder.c_str());
  if (entries == nullptr) {
    rcutils_set_error_state("the directory cannot be opened", __FILE__, __LINE__);
    return RCUTILS_RET_ERROR;
  }
  rcutils_ret_t result = RCUTILS_RET_OK;
  while (const dirent* const entry = readdir(entries)) {
    const std::string name = entry->d_name;
    if (name == "." || name == "..") {
      continue;
    }
    const std::string path = folder + "/" + name;
    if (!rcutils_is_directory(path.c_str())) {
      size += rcutils_get_file_size(path.c_str());
    } else if (!limited || depth > 1) {
      result = add_sizes(path, limited ? depth - 1 : 0, limited, size);
      if (result != RCUTILS_RET_OK) {
        break;
      }
    }
  }
  closedir(entries);
  return result;
}

rcutils_ret_t directory_size(const char* path, size_t depth, bool limited, uint64_t* size) {
  if (path == nullptr || size == nullptr) {
    rcutils_set_error_state("directory_path or size is null", __FILE__, __LINE__);
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  if (!rcutils_is_directory(path)) {
    rcutils_set_error_state("the path is not a directory", __FILE__, __LINE__);
    return RCUTILS_RET_ERROR;
  }
  *size = 0;
  return add_sizes(path, depth, limited, *size);
}

}  // namespace

extern "C" {

bool rcutils_get_cwd(char* buffer, size_t max_length) {
  return buffer != nullptr && getcwd(buffer, max_length) != nullptr;
}

bool rcutils_is_directory(const char* path) {
  struct stat status {};
  return read_status(path, status) && S_ISDIR(status.st_mode);
}

bool rcutils_is_file(const char* path) {
  struct stat status {};
  return read_status(path, status) && S_ISREG(status.st_mode);
}

bool rcutils_exists(const char* path) {
  struct stat status {};
  return read_status(path, status);
}

bool rcutils_is_readable(const char* path) {
  struct stat status {};
  return read_status(path, status) && (status.st_mode & S_IRUSR) != 0;
}

bool rcutils_is_writable(const char* path) {
  struct stat status {};
  return read_status(path, status) && (status.st_mode & S_IWUSR) != 0;
}

bool rcutils_is_readable_and_writable(const char* path) {
  return rcutils_is_readable(path) && rcutils_is_writable(path);
}

char* rcutils_join_path(const char* left, const char* right, rcutils_allocator_t allocator) {
  if (left == nullptr || right == nullptr) {
    return nullptr;
  }
  return copy(std::string(left) + "/" + right, allocator);
}

char* rcutils_to_native_path(const char* path, rcutils_allocator_t allocator) {
  return path == nullptr ? nullptr : copy(path, allocator);
}

char* rcutils_expand_user(const char* path, rcutils_allocator_t allocator) {
  if (path == nullptr) {
    return nullptr;
  }
  if (path[0] != '~') {
    return copy(path, allocator);
  }
  const char* const home = rcutils_get_home_dir();
  return home == nullptr ? nullptr : copy(std::string(home) + (path + 1), allocator);
}

/* True also when the folder is there already. */
bool rcutils_mkdir(const char* path) {
  if (path == nullptr || path[0] != '/') {
    return false;
  }
  return mkdir(path, 0775) == 0 || (errno == EEXIST && rcutils_is_directory(path));
}

rcutils_ret_t rcutils_calculate_directory_size(const char* directory_path, uint64_t* size,
                                               rcutils_allocator_t) {
  return directory_size(directory_path, 1, true, size);
}

rcutils_ret_t rcutils_calculate_directory_size_with_recursion(const char* directory_path,
                                                              const size_t max_depth,
                                                              uint64_t* size, rcutils_allocator_t) {
  return directory_size(directory_path, max_depth, max_depth != 0, size);
}

size_t rcutils_get_file_size(const char* path) {
  struct stat status {};
  return read_status(path, status) && S_ISREG(status.st_mode) ? static_cast<size_t>(status.st_size)
                                                              : 0;
}

rcutils_dir_iter_t* rcutils_dir_iter_start(const char* directory_path,
                                           const rcutils_allocator_t allocator) {
  DIR* const folder = directory_path == nullptr ? nullptr : opendir(directory_path);
  if (folder == nullptr) {
    rcutils_set_error_state("the directory cannot be opened", __FILE__, __LINE__);
    return nullptr;
  }
  auto* const iter = static_cast<rcutils_dir_iter_t*>(
      allocator.zero_allocate(1, sizeof(rcutils_dir_iter_t), allocator.state));
  if (iter == nullptr) {
    closedir(folder);
    return nullptr;
  }
  iter->allocator = allocator;
  iter->state = folder;
  if (!rcutils_dir_iter_next(iter)) {
    rcutils_dir_iter_end(iter);
    return nullptr;
  }
  return iter;
}

bool rcutils_dir_iter_next(rcutils_dir_iter_t* iter) {
  const dirent* const entry = iter == nullptr ? nullptr : readdir(static_cast<DIR*>(iter->state));
  if (iter != nullptr) {
    iter->entry_name = entry == nullptr ? nullptr : entry->d_name;
  }
  return entry != nullptr;
}

void rcutils_dir_iter_end(rcutils_dir_iter_t* iter) {
  if (iter != nullptr) {
    closedir(static_cast<DIR*>(iter->state));
    iter->allocator.deallocate(iter, iter->allocator.state);
  }
}

}  // extern "C"
