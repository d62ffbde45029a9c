// One row per command. A command lives in cli/<name>_command.cpp and is declared here, above the
// table.
#include "cli/command_table.hpp"

#include <array>

namespace ros2wasm {

CommandBody check_command(Arguments& arguments);
CommandBody explain_command(Arguments& arguments);
CommandBody link_program_command(Arguments& arguments);
CommandBody version_command(Arguments& arguments);

namespace {

constexpr auto kCommands = std::to_array<CommandRow>({
    {.name = "check",
     .help = "Check a workspace.yaml and say all that is wrong",
     .declare = check_command},
    {.name = "explain", .help = "Say more about an error code", .declare = explain_command},
    {.name = "link-program",
     .help = "Link one program (called by CMake)",
     .declare = link_program_command,
     .hidden = true},
    {.name = "version", .help = "Print the version", .declare = version_command},
});

}  // namespace

std::span<const CommandRow> command_table() {
  return kCommands;
}

}  // namespace ros2wasm
