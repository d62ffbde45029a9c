// `ros2wasm link-program`: links one program of a package. CMake calls it through the toolchain
// file.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bundler/build/link_line.hpp"
#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct LinkRequest {
  std::string package;                             ///< for messages; may be empty
  std::vector<std::string> command;                ///< compiler and arguments, with -o
  std::map<std::string, std::string> environment;  ///< for the compiler, see tool_environment()
  std::string thread_support;                      ///< source that programs with threads get:
                                                   ///< templates/toolchain/src/thread_support.cpp
  std::string kits;        ///< folder for what a second link needs (link_kit.hpp); may be empty
  std::string tool_calls;  ///< links as direct_link.hpp says, which keeps its findings here; may
                           ///< be empty
  bool quick = false;      ///< leaves out the optimizer of whole programs
  std::string channel_prefix;  ///< of the channels' libraries: what they refer to and never call
                               ///< fails nobody; may be empty
};

/// The variable with the channel_prefix of `ros2wasm link-program`.
inline constexpr const char* kChannelPrefixVariable = "ROS2WASM_CHANNEL_PREFIX";

/// The variable with the tool_calls of `ros2wasm link-program`.
inline constexpr const char* kToolCallsVariable = "ROS2WASM_TOOL_CALLS";

/// The variable that asks `ros2wasm link-program` for quick links: "1", or empty.
inline constexpr const char* kQuickLinkVariable = "ROS2WASM_QUICK_LINK";

struct LinkReport {
  std::string program;  ///< the file written
  LinkKind kind = LinkKind::kSingle;
  Diagnostics warnings = {};  ///< R2W0524 what it asks for and no browser has
};

/// Links singly; links again for threads when the program starts any. R2W0504 symbols that nothing
/// defines, R2W0523 what no browser has, R2W0505 the linker failed otherwise. A library of plugins
/// becomes a kit only. The output appears whole or not at all.
[[nodiscard]] Outcome<LinkReport> link_program(const LinkRequest& request,
                                               const Cancellation& cancellation);

}  // namespace ros2wasm
