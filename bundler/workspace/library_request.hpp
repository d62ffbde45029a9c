// The libraries of Pyodide's distribution that a workspace asks for. Pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bundler/store/wheel_files.hpp"
#include "bundler/workspace/channel_request.hpp"
#include "bundler/workspace/python_libraries.hpp"

namespace ros2wasm {

/// The question, beside what the manifest says.
struct LibraryQuestion {
  const Manifest& manifest;
  const std::vector<LocalPackage>& packages;
  const LeftOutPackages& left_out;
  const std::vector<NamedWheel>& wheels;
  const KnownNames& known;
  const std::vector<Spanned<std::string>>& notebook_modules;
  const PythonLibraries& libraries;
};

struct LibraryRequest {
  std::vector<LockedLibrary> libraries;  ///< with what they need; sorted by project
  std::vector<RequestedSpec> specs;      ///< what they need that a channel has
  Diagnostics warnings;
};

/// Asked for are: `python: packages:`; modules that a file of a package needs and that neither the
/// workspace, a wheel nor a channel has; modules that it imports in a function or `try`, when its
/// package.xml names their rosdep key; what wheels require; modules of the notebook. Of what they
/// depend on, wheels and channels give what they have. R2W0127 the distribution has no such
/// library. R2W0247, a warning: another version than the workspace asks for.
[[nodiscard]] Outcome<LibraryRequest> library_request(const LibraryQuestion& question);

/// Takes away what libraries bring, as drop_met_by_wheels() does.
void drop_met_by_libraries(const std::vector<LockedLibrary>& locked,
                           const PythonLibraries& libraries, const KnownNames& known,
                           std::string_view distro, std::vector<LocalPackage>& packages);

}  // namespace ros2wasm
