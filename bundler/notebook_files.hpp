// The notebook of the page: what a workspace has of it; and all that a site gets for its page.
#pragma once

#include <string>
#include <vector>

#include "bundler/pack_values.hpp"

namespace ros2wasm {

/// Reads it into the workspace, if the manifest names one. Gives the modules that its code imports.
/// R2W0118, R2W0124.
[[nodiscard]] Outcome<std::vector<Spanned<std::string>>> read_notebook(ReadWorkspace& workspace);

/// Texts, bags, the notebook: each file once. R2W0118.
[[nodiscard]] Outcome<Done> add_page(const ReadWorkspace& workspace, PlanInput& input,
                                     PackNotes& notes);

}  // namespace ros2wasm
