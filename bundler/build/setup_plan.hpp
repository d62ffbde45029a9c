// The files that a setup.py would install, as templates/python/read_setup.mjs reports them. Pure.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "bundler/build/compile_errors.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// A file of the package and where it goes.
struct SetupFile {
  std::string from;  ///< relative to the package
  std::string to;    ///< relative to the folder of modules, or to the prefix
};

/// A file that setup.py itself makes.
struct WrittenFile {
  std::string to;  ///< below the prefix
  std::string text;
};

/// `count = chatter_py.count:main` of the group console_scripts.
struct EntryPoint {
  std::string name;
  std::string module;
  std::string function;  ///< may have dots; empty: the entry names the module only
};

struct SetupPlan {
  std::string name;
  std::string version;
  std::vector<SetupFile> modules;    ///< below the folder of modules
  std::vector<SetupFile> data;       ///< below the prefix
  std::vector<SetupFile> scripts;    ///< programs as they are, below the prefix
  std::vector<WrittenFile> written;  ///< by setup.py itself; the others come over these
  std::string script_folder;         ///< where programs go, below the prefix
  std::vector<EntryPoint> programs;
  std::map<std::string, std::vector<std::string>> entry_points;  ///< all groups, as they stand
  Diagnostics warnings;  ///< R2W0527; places are below the package's folder
};

/// R2W0516 setup.py failed, or wants what cannot be: with its file and line.
[[nodiscard]] Outcome<SetupPlan> read_setup_plan(std::string_view json, const BuildPlace& place);

/// The program that stands for an entry point.
[[nodiscard]] std::string entry_point_script(const EntryPoint& entry, const std::string& package);

/// entry_points.txt, which importlib.metadata reads.
[[nodiscard]] std::string entry_points_text(const SetupPlan& plan);

}  // namespace ros2wasm
