// Evaluates the launch file of a site when it starts, with the launch arguments that it is given.
// Runs in the site (runtime/launch_evaluator) and in tests. Pure: JSON in, JSON out.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "bundler/launch/launch_scope.hpp"

namespace ros2wasm {

/// Abilities of the place where a launch is evaluated, in addition to the question.
struct LaunchPlace {
  LaunchPython python = {};  ///< runs launch files in Python; empty: what they answered stands
  /// A file of `shared`, at once; empty: it is fetched when the answer says so.
  std::function<std::optional<std::string>(const std::string& path)> file = {};
};

/// `question`: `launch` (launch.json), `given` (launch arguments by name), `shared` (the files of
/// packages that the site has, below the prefix), `files` (texts of those that were fetched).
/// The answer has one of
/// - `needs`: files of `shared` that must be fetched before the same is asked again,
/// - `errors`: diagnostics with `code`, `message`, `source`, `why`, `fix`; and `decided`,
/// - `nodes` (as in site.json), with `arguments`, `warnings`, `remarks`, and `decided`: whether
///   something is as it was for other arguments, because only Python knows better.
/// With `"describe": true` it has `description` instead of nodes: what `ros2wasm launch --json`
/// prints. R2W0730 an argument that no launch file declares, R2W0731 a program that the site has
/// not.
[[nodiscard]] std::string evaluate_packed_launch(std::string_view question,
                                                 const LaunchPlace& place = {});

}  // namespace ros2wasm
