// Evaluates the launch file of a site when it starts, with the launch arguments that it is given.
// Runs in the site (runtime/launch_evaluator) and in tests. Pure: JSON in, JSON out.
#pragma once

#include <string>
#include <string_view>

namespace ros2wasm {

/// `question`: `launch` (launch.json), `given` (launch arguments by name), `shared` (the files of
/// packages that the site has, below the prefix), `files` (texts of those that were fetched).
/// The answer has one of
/// - `needs`: files of `shared` that must be fetched before the same is asked again,
/// - `errors`: diagnostics with `code`, `message`, `source`, `why`, `fix`,
/// - `nodes` (as in site.json), with `arguments`, `warnings`, `remarks`, and `decided`: whether
///   something is as it was for other arguments, because only Python knows better.
/// With `"describe": true` it has `description` instead of nodes: what `ros2wasm launch --json`
/// prints. R2W0730 an argument that no launch file declares, R2W0731 a program that the site has
/// not.
[[nodiscard]] std::string evaluate_packed_launch(std::string_view question);

}  // namespace ros2wasm
