// info/link.json of a package: how conda installs what does not lie in the archive as it is
// installed. Pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// A command that calls a function of a Python module: "pip = pip._internal:main".
struct EntryPoint {
  std::string command;
  std::string module;
  std::string function;

  bool operator==(const EntryPoint&) const = default;
};

/// In the order of the file. R2W0221 when it cannot be read, a command could be no file in bin/, or
/// module and function are no names of Python. `name` is for messages.
[[nodiscard]] Outcome<std::vector<EntryPoint>> parse_entry_points(std::string_view link_json,
                                                                  const std::string& name);

}  // namespace ros2wasm
