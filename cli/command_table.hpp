// All commands of the program: one row each.
#pragma once

#include <span>
#include <string_view>

#include "cli/context.hpp"

namespace ros2wasm {

class Arguments;

/// Declares the options of a command and returns what runs it.
using CommandDeclaration = CommandBody (*)(Arguments& arguments);

struct CommandRow {
  std::string_view name;
  std::string_view help;  ///< one line, for people who do not know the program
  CommandDeclaration declare;
  bool hidden = false;  ///< called by other tools, not shown in --help
};

/// In the order of --help.
[[nodiscard]] std::span<const CommandRow> command_table();

}  // namespace ros2wasm
