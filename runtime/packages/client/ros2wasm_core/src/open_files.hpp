// The open files of a program, used by the C library's calls: file_calls.cpp has those for paths
// and folders, fd_calls.cpp those for descriptors.
#pragma once

#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "file_tree.hpp"

namespace ros2wasm {

constexpr int kFirst = 3;  ///< descriptor of a file of the tree
constexpr int64_t kLargestFile = INT32_MAX;

struct OpenFile {
  File file;
  int64_t position = 0;  ///< bytes; of a folder: entries told
  int flags = 0;
  std::string last_told;  ///< of a folder: entries come and go while it is listed
};

struct Files {
  std::mutex mutex;
  FileTree tree;
  std::vector<OpenFile> open;  ///< by descriptor - kFirst; no file: free

  OpenFile* at(int fd) {
    const size_t index = static_cast<size_t>(fd) - kFirst;
    return fd >= kFirst && index < open.size() && open[index].file ? &open[index] : nullptr;
  }
};

/// Never destroyed: programs close files while they end.
Files& files();

using Lock = std::lock_guard<std::mutex>;

/// 0, or an errno below 0.
long resize(FileNode& file, int64_t size);

/// Joins the two halves of an offset.
constexpr int64_t whole(long low, long high) {
  return (static_cast<int64_t>(high) << 32) | static_cast<uint32_t>(low);
}

}  // namespace ros2wasm
