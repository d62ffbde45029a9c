// A launch file as a site has it, to be evaluated when the site starts. Plain values.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bundler/launch/launch_description.hpp"
#include "bundler/launch/launch_graph.hpp"
#include "bundler/launch/python_record.hpp"

namespace ros2wasm {

struct PackedLaunch {
  std::string file;                                   ///< as launch files see it
  SourceSpan from;                                    ///< where the manifest names it
  std::map<std::string, std::string> given;           ///< by the manifest
  std::map<std::string, std::string> variables = {};  ///< of the environment, by the manifest
  std::string distro;
  std::vector<InstalledPackage> installed;
  LeftOutChains left_out;                    ///< packages that were not built, and why
  std::map<std::string, std::string> texts;  ///< files of the workspace, by path
  std::vector<PythonExchange> python;
  std::vector<LaunchArgument> arguments;  ///< with the values that the site is packed with
  std::vector<std::string> tried;         ///< names of those of which each value was tried
  /// Files that launch files in Python import, when the site runs them anew.
  std::map<std::string, std::string> modules;
};

}  // namespace ros2wasm
