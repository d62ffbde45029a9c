// The files that `ros2wasm init` writes: a manifest for an existing workspace, or a new workspace
// from a template. Both write all of their files or none, and never over one that exists.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "workspace_schema/base/outcome.hpp"

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

/// A manifest at `output` (beside `file` when empty) with the channels and dependencies of another
/// tool's file and the packages beside it; from a lock, a ros2wasm.lock of its packages too.
/// R2W0630, R2W0340, R2W0341, R2W0311 when the lock's packages do not fit together.
[[nodiscard]] Outcome<InitReport> init_from_environment(const std::filesystem::path& file,
                                                        const std::filesystem::path& output,
                                                        const std::string& environment);

/// Copies the files of `template_folder` to `target`, named after its last part. R2W0630.
[[nodiscard]] Outcome<InitReport> init_from_template(const std::filesystem::path& template_folder,
                                                     const std::filesystem::path& target);

/// Copies the workflow `template_file` to `target`, in the repository `folder`. R2W0630. Remarks
/// say what its commands will miss there.
[[nodiscard]] Outcome<InitReport> init_workflow(const std::filesystem::path& template_file,
                                                const std::filesystem::path& folder,
                                                const std::filesystem::path& target);

}  // namespace ros2wasm
