// The notebook of the page: what a workspace has of it; and all that a site gets for its page.
#pragma once

#include <string>
#include <vector>

#include "bundler/pipeline.hpp"

namespace ros2wasm {

/// Reads it into the workspace, if the manifest names one. Gives the modules that its code imports.
/// R2W0118, R2W0124.
[[nodiscard]] Outcome<std::vector<Spanned<std::string>>> read_notebook(BuiltWorkspace& workspace);

/// Texts, bags, the notebook: each file once. R2W0118.
[[nodiscard]] Outcome<Done> add_page(BuiltWorkspace& workspace, PlanInput& input);

}  // namespace ros2wasm
