// Plans a site: every file with its size, its SHA-256 and the reason it is there. Pure.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bundler/launch/launch_graph.hpp"
#include "bundler/launch/packed_launch.hpp"
#include "bundler/launch/unsupported_programs.hpp"
#include "bundler/plan/python_site.hpp"
#include "bundler/render/site_plan.hpp"
#include "bundler/site/site_component.hpp"
#include "bundler/site/site_file.hpp"
#include "bundler/workspace/installed_tree.hpp"
#include "bundler/workspace/share_tree.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

/// A file that the built runtime brings to every site.
struct RuntimeAsset {
  std::string file;
  std::string role;
  std::string bytes;
};

/// The page's notebook, whose kernel is a Python program.
struct NotebookInput {
  std::string file;                         ///< relative to the manifest
  std::vector<std::string> compiled;        ///< modules with compiled parts that its cells import
  std::vector<std::string> libraries = {};  ///< as LaunchNode has it
};

/// The inputs of plan_site().
struct PlanInput {
  const Manifest& manifest;
  std::vector<LaunchNode> nodes;
  std::vector<LaunchStep> steps;
  std::vector<LaunchNode> more_nodes;  ///< of programs that none of these runs
  std::optional<PackedLaunch> launch;
  std::string launch_package;        ///< in which the manifest's launch file lies; or none
  std::vector<StandInPanel> panels;  ///< of the usual layout
  std::map<std::filesystem::path, std::string> programs;  ///< bytes of each node's program file
  std::map<std::filesystem::path, std::string> names;     ///< by program file, where there are any
  std::vector<RuntimeAsset> runtime;
  InterfaceTexts interfaces;
  SharedFiles shared;                     ///< of all packages
  std::vector<std::string> packages;      ///< of the workspace
  PythonInput python;                     ///< empty without Python nodes
  std::vector<std::string> python_index;  ///< all packages that Python nodes can find
  std::vector<SiteComponent> components;  ///< what the site is made of
  std::vector<PageFile> text;             ///< Markdown and notebook of the page, their images
  std::vector<PageFile> bags;             ///< recordings that the page plays
  std::optional<NotebookInput> notebook;
  std::string sources = {};         ///< archive of what the site is made of; empty: it carries none
  std::uint64_t max_file_size = 0;  ///< bytes; larger files are split into parts; 0: no limit
  std::string store = {};           ///< where the store lies that the site shares; see SiteStore
};

/// R2W0606 a program is not WebAssembly, R2W0430 a check names a node that is not there.
[[nodiscard]] Outcome<SitePlan> plan_site(PlanInput input);

}  // namespace ros2wasm
