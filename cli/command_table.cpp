// One row per command. A command lives in cli/<name>_command.cpp and is declared here, above the
// table.
#include "cli/command_table.hpp"

#include <array>

namespace ros2wasm {

CommandBody build_command(Arguments& arguments);
CommandBody cache_command(Arguments& arguments);
CommandBody channel_command(Arguments& arguments);
CommandBody check_command(Arguments& arguments);
CommandBody diff_command(Arguments& arguments);
CommandBody explain_command(Arguments& arguments);
CommandBody grade_command(Arguments& arguments);
CommandBody inspect_command(Arguments& arguments);
CommandBody init_command(Arguments& arguments);
CommandBody compile_source_command(Arguments& arguments);
CommandBody launch_command(Arguments& arguments);
CommandBody describe_compiler_command(Arguments& arguments);
CommandBody install_kits_command(Arguments& arguments);
CommandBody link_program_command(Arguments& arguments);
CommandBody lock_command(Arguments& arguments);
CommandBody pack_command(Arguments& arguments);
CommandBody rebuild_command(Arguments& arguments);
CommandBody ros2_command(Arguments& arguments);
CommandBody run_command(Arguments& arguments);
CommandBody schema_command(Arguments& arguments);
CommandBody search_command(Arguments& arguments);
CommandBody serve_command(Arguments& arguments);
CommandBody solve_command(Arguments& arguments);
CommandBody tree_command(Arguments& arguments);
CommandBody verify_command(Arguments& arguments);
CommandBody version_command(Arguments& arguments);
CommandBody why_command(Arguments& arguments);

namespace {

// The commands that most people want come first.
constexpr auto kCommands = std::to_array<CommandRow>({
    {.name = "pack", .help = "Pack a workspace into a site", .declare = pack_command},
    {.name = "serve", .help = "Serve a packed site on this machine", .declare = serve_command},
    {.name = "run",
     .help = "Run a packed site in Node.js, without a browser",
     .declare = run_command},
    {.name = "ros2",
     .help = "Run a command of ros2 on a packed site, in Node.js",
     .declare = ros2_command},
    {.name = "init", .help = "Begin a workspace, or a manifest for one", .declare = init_command},
    {.name = "check",
     .help = "Check a workspace.yaml and say all that is wrong",
     .declare = check_command},
    {.name = "build",
     .help = "Compile a workspace, without making a site",
     .declare = build_command},
    {.name = "launch", .help = "Show what a launch file comes to", .declare = launch_command},
    {.name = "why",
     .help = "Say why a file is in a site, or a package in the lock",
     .declare = why_command},
    {.name = "verify",
     .help = "Check every byte of a site against its list of hashes",
     .declare = verify_command},
    {.name = "diff", .help = "Say what differs between two sites", .declare = diff_command},
    {.name = "grade",
     .help = "Show what students have handed in, and check that it was not changed",
     .declare = grade_command},
    {.name = "rebuild",
     .help = "Make a site once more from what it carries, and compare",
     .declare = rebuild_command},
    {.name = "tree", .help = "Show which package needs which in the lock", .declare = tree_command},
    {.name = "lock", .help = "Write or check ros2wasm.lock", .declare = lock_command},
    {.name = "cache",
     .help = "Look after downloaded packages: info, verify, prune, fetch",
     .declare = cache_command},
    {.name = "search", .help = "Show what the channels have", .declare = search_command},
    {.name = "channel", .help = "Make a channel of packages", .declare = channel_command},
    {.name = "schema",
     .help = "Print the JSON Schema of workspace.yaml",
     .declare = schema_command},
    {.name = "explain", .help = "Say more about an error code", .declare = explain_command},
    {.name = "solve",
     .help = "Choose packages for specs, without a workspace",
     .declare = solve_command},
    {.name = "version", .help = "Print the version", .declare = version_command},
    {.name = "inspect",
     .help = "Show what ros2wasm makes of a version, a spec or an archive",
     .declare = inspect_command},
    {.name = "describe-compiler",
     .help = "Tell what of the compiler is in programs (called where a channel is made)",
     .declare = describe_compiler_command,
     .hidden = true},
    {.name = "compile-source",
     .help = "Compile one source (called by CMake)",
     .declare = compile_source_command,
     .hidden = true},
    {.name = "install-kits",
     .help = "Install how programs are linked (called where a channel is made)",
     .declare = install_kits_command,
     .hidden = true},
    {.name = "link-program",
     .help = "Link one program (called by CMake)",
     .declare = link_program_command,
     .hidden = true},
});

}  // namespace

std::span<const CommandRow> command_table() {
  return kCommands;
}

}  // namespace ros2wasm
