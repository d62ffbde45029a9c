// The input and output of readers of worlds and models. They never reach the disk themselves.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "world/world.hpp"

namespace ros2wasm_sim {

enum class Severity { kWarning, kError };

/// Something to say about a file: where it is, and what is wrong.
struct Note {
  Severity severity = Severity::kWarning;
  std::string file;      ///< as it is named to people; empty: text that came by a topic or service
  std::size_t line = 0;  ///< from 1; 0: none
  std::size_t column = 0;
  std::string text;
};

struct Resources {
  /// The file or folder of a URI (`model://`, `package://`, `file://`, a path), or nothing. The
  /// second value is the list of folders that were searched, for messages.
  std::function<std::optional<std::string>(const std::string& uri,
                                           std::vector<std::string>& searched)>
      find;
  std::function<std::optional<std::string>(const std::string& path)> read;
  /// The paths of the files in a folder, sorted; none for a path that is not a folder. May be
  /// empty.
  std::function<std::vector<std::string>(const std::string& path)> list = {};
};

/// A value is missing exactly when a note is an error.
template <typename T>
struct Reading {
  std::optional<T> value;
  std::vector<Note> notes;
};

}  // namespace ros2wasm_sim
