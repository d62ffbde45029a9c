// The build of one package: its tools, its folders, and the function that languages/ has for each
// build type.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "bundler/build/compile_errors.hpp"
#include "bundler/build/compiler.hpp"
#include "bundler/workspace/build_order.hpp"
#include "bundler/workspace/discovery.hpp"
#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/base/progress_event.hpp"

namespace ros2wasm {

/// The tools that build packages, the same for all packages of a pack.
struct BuildTools {
  Compiler compiler;
  EnvironmentVariables compiler_environment;
  EnvironmentVariables tool_environment;
  std::filesystem::path toolchain;     ///< ros2wasm-toolchain.cmake
  std::filesystem::path c_messages;    ///< templates/c_messages
  std::filesystem::path cli;           ///< this program, for compile-source and link-program
  unsigned jobs = 1;                   ///< compilers at once, of all packages
  std::filesystem::path tool_calls;    ///< programs are linked as direct_link.hpp says
  bool quick = false;                  ///< without the optimizer of whole programs
  std::filesystem::path kept_headers;  ///< for compile-source; empty: the compiler is called itself
  std::filesystem::path node_js;       ///< reads setup.py files; empty when no package has one
  std::filesystem::path python_templates;  ///< templates/python, likewise
};

/// One package to build.
struct PackageBuild {
  BuildPlace place;
  std::vector<std::filesystem::path>
      prefixes;  ///< where its dependencies are installed, nearest first
  std::filesystem::path
      work;  ///< kept from run to run, so that only what changed is compiled again
  std::filesystem::path install;         ///< empty folder to install into
  std::filesystem::path final_prefix;    ///< what `install` will be called later
  std::filesystem::path channel_prefix;  ///< of its dependencies from the channels; may be empty
  std::filesystem::path workspace;       ///< its folder: links of the package may lead there
  unsigned jobs = 1;                     ///< compilers at once, of this package
};

/// In the folder of work, what link-program leaves for a second link (link_kit.hpp).
inline constexpr const char* kLinkKits = "link-kits";

using PackageBuilder = Outcome<Done>(const PackageBuild& request, const BuildTools& tools,
                                     const Cancellation& cancellation,
                                     const ProgressSink& progress);

/// The builder of a build type; null for an unknown one.
using BuilderOf = PackageBuilder*(std::string_view build_type);

}  // namespace ros2wasm
