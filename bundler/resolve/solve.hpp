// Chooses one record per package. Pure: request and index in, choice or explanation out.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bundler/channel/channel_index.hpp"
#include "bundler/resolve/search_budget.hpp"
#include "workspace_schema/base/diagnostic.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/conda/package_record.hpp"

namespace ros2wasm {

/// A package that says which Emscripten built the libraries of a channel; programs must come of the
/// same one.
inline constexpr std::string_view kCompilerPackage = "emscripten-abi";
/// Its build stands for the headers of the client libraries that a package was compiled with.
inline constexpr std::string_view kClientAbiPackage = "ros2wasm-abi";

/// Something that must be in the solution.
struct RequestedSpec {
  std::string text;                ///< a match spec: "ros-jazzy-rclcpp >=28"
  std::string origin;              ///< who asks, for messages: "package.xml of demo"; may be empty
  std::optional<SourceSpan> span;  ///< where it is written
};

struct ResolveRequest {
  std::vector<RequestedSpec> specs;
  std::vector<PackageRecord> locked;  ///< kept when they still fit
  ChannelPriority priority = ChannelPriority::kStrict;
};

struct Resolution {
  /// One record per name, each after all that it needs; otherwise by name.
  std::vector<PackageRecord> packages;
  /// Records that would have been preferred, but have specs that cannot be read.
  std::vector<LeftOutRecord> left_out;
};

/// Newest version first, then highest build number, then a fixed rule, so that the same request and
/// records give the same answer on every machine and in every order of records. `__unix` and
/// `__archspec` are there. R2W0301 no choice fits (with a tree of reasons), R2W0302 no channel has
/// such a name, R2W0303 bad match spec, R2W0305 and R2W0903 see best_choice().
[[nodiscard]] Outcome<Resolution> solve(const ResolveRequest& request, const RepoIndex& index,
                                        const SearchBudget& budget = {});

/// Why `packages` is not a solution of `specs`: one diagnostic (R2W0311) per edge that does not
/// hold; empty when it is one. `built_here` as in RepoIndex. Needs no index and no network.
[[nodiscard]] Diagnostics check_solution(const std::vector<RequestedSpec>& specs,
                                         const std::vector<PackageRecord>& packages,
                                         const std::vector<PackageRecord>& built_here = {});

}  // namespace ros2wasm
