// What `ros2wasm init` puts on the disk: a manifest for a workspace that is there, or a new
// workspace from a template. Both write all of their files or none, and never over one that exists.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "workspace_schema/outcome.hpp"

namespace ros2wasm {

struct InitReport {
  std::vector<std::filesystem::path> written;
  std::vector<std::string> remarks;  ///< what was chosen, for people
};

/// A manifest at `output` for the packages below `workspace`. R2W0630 `output` exists, R2W0631
/// there is no package, R2W0632 no program was seen in them; errors of package.xml files as they
/// are.
[[nodiscard]] Outcome<InitReport> init_from_workspace(const std::filesystem::path& workspace,
                                                      const std::filesystem::path& output);

/// Copies the files of `template_folder` to `target`, named after its last part. R2W0630.
[[nodiscard]] Outcome<InitReport> init_from_template(const std::filesystem::path& template_folder,
                                                     const std::filesystem::path& target);

}  // namespace ros2wasm
