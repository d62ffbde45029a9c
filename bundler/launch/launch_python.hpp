// Talks with the interpreter of launch files in Python (templates/python/read_launch.mjs), which
// records what they describe and asks back for what only the evaluation knows. Pure but for what
// the world's functions do.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "bundler/launch/launch_description.hpp"
#include "bundler/launch/launch_entity.hpp"
#include "bundler/launch/launch_scope.hpp"

namespace ros2wasm {

/// Where the evaluation is when Python is asked.
struct PythonMoment {
  const LaunchScope& scope;
  const LaunchFilePlace& file;
  const LaunchWorld& world;
  const SourceSpan& span;  ///< who asks
  std::function<void(LaunchLine)> said = {};
};

/// The result of running some Python. Changes of variables are for the whole process.
struct PythonActions {
  LaunchEntity root;  ///< its children are the actions
  std::map<std::string, std::string> configurations;
  std::map<std::string, std::string> environment;  ///< the ones that were set
  std::vector<std::string> unset;
};

/// The actions of a launch file. R2W0416 with the place in the file; R2W0517.
[[nodiscard]] Outcome<PythonActions> load_python_launch(const std::string& path,
                                                        const PythonMoment& moment);

/// The actions that the function of that number returns at the current point of the evaluation.
[[nodiscard]] Outcome<PythonActions> call_python_launch(std::int64_t number,
                                                        const PythonMoment& moment);

/// The text of a substitution that the launch file itself made.
[[nodiscard]] Outcome<std::string> perform_python(std::int64_t number, const PythonMoment& moment);

/// A file that the launch file wrote. Errors as those of LaunchWorld::read.
[[nodiscard]] Outcome<std::string> read_python_file(const std::string& path,
                                                    const LaunchWorld& world);

}  // namespace ros2wasm
