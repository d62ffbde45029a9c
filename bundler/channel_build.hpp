// `ros2wasm channel build`: the packages of a workspace, of repositories or of a distribution as a
// channel.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "bundler/request.hpp"

namespace ros2wasm {

struct ChannelBuildRequest {
  PackRequest pack;                ///< the workspace, or further sources
  std::filesystem::path channel;   ///< folder; what it has already stays
  std::vector<std::string> names;  ///< packages asked for by name: each must be built, or be there
};

enum class ChannelPackageState {
  kAdded,      ///< its archive was written
  kUnchanged,  ///< the channel has it as it would be written
  kFailed,     ///< it does not build, or cannot be packed
  kSkipped,    ///< it lacks something, or needs a package that failed
};

struct ChannelPackage {
  std::string name;     ///< as package.xml says
  std::string version;  ///< empty when it was not read
  std::string origin;   ///< address and commit; empty: a folder of the user's
  std::string archive;  ///< `<subdir>/<file>` in the channel; empty when there is none
  ChannelPackageState state = ChannelPackageState::kAdded;
  Diagnostics errors;               ///< of one that failed
  std::vector<std::string> reason;  ///< of one that is skipped, the nearest cause first
};

struct ChannelBuildReport {
  std::vector<ChannelPackage> packages;  ///< sorted by name
  Diagnostics warnings;
  std::vector<std::string> remarks;
};

/// Builds, adds archives to the channel and writes its index. A package that fails stops only those
/// that need it. The same sources, compiler and channels give the same archives. What an earlier
/// run has added stays in the channel, so that locks which name it hold: another build of the same
/// version gets the next build number.
[[nodiscard]] Outcome<ChannelBuildReport> build_channel(const ChannelBuildRequest& request,
                                                        const Cancellation& cancellation,
                                                        const ProgressSink& progress);

/// Failures by cause, then packages; for people.
[[nodiscard]] std::string channel_report_markdown(const ChannelBuildReport& report);
[[nodiscard]] std::string channel_report_json(const ChannelBuildReport& report);

}  // namespace ros2wasm
