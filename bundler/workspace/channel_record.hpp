// A built package of a workspace as a channel names it. Pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bundler/archive/conda_writer.hpp"
#include "bundler/workspace/build_order.hpp"

namespace ros2wasm {

/// The tools and headers that compiled packages are bound to.
struct ChannelAbi {
  std::string compiler_version;  ///< "3.1.6"
  std::string compiler_build;    ///< of kCompilerPackage; empty: any of that version
  std::string client_build;      ///< of kClientAbiPackage; empty: the channels do not say
};

/// Everything but the build string, which is known when the files are. Needs of others: what
/// package.xml names for use
/// (`depend`, `exec_depend`, `*_export_depend`) with its limits of versions, and what the package
/// uses without naming it; only packages that the workspace or a channel has. `packages`: all of
/// the workspace.
[[nodiscard]] CondaPackage channel_record(const LocalPackage& package,
                                          const std::vector<LocalPackage>& packages,
                                          const KnownNames& known, std::string_view distro,
                                          bool is_compiled, const ChannelAbi& abi);

/// "em316_h0123abcd_0" of a compiled package, "h0123abcd_0" of another: by the hash of the files,
/// so that the same files have the same name wherever they were made.
[[nodiscard]] std::string channel_build_string(const CondaPackage& package, const ChannelAbi& abi,
                                               std::string_view files_hash);

}  // namespace ros2wasm
