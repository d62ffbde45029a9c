// The needs of the Python nodes of a site: the files that they find installed, and whether their
// imports can be met.
#pragma once

#include <vector>

#include "bundler/pack_values.hpp"
#include "bundler/request.hpp"

namespace ros2wasm {

/// When there are Python nodes: Pyodide, and all modules and scripts of the workspace and its
/// channels' packages. What is skipped becomes a remark. R2W0210, R2W0517;
/// R2W0518 for what programs import and nobody has, R2W0528 for files that are not valid Python.
/// Nodes that nobody named, or that only other launch arguments start, are skipped for that, with
/// warnings; each of the others gets its `compiled_modules`.
[[nodiscard]] Outcome<Done> add_python(const PackRequest& request, const BuiltWorkspace& workspace,
                                       bool nodes_by_default, PlanInput& input, PackNotes& notes,
                                       const Cancellation& cancellation);

/// Adds the tools that read setup.py files: Node.js and the script of ros2wasm for it.
[[nodiscard]] Outcome<Done> add_python_tools(const PackRequest& request, BuildTools& tools,
                                             const Cancellation& cancellation);

}  // namespace ros2wasm
