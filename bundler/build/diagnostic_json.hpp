// Diagnostics as JSON: how the link driver, a grandchild of the pack, hands its findings up, and
// what is kept with what was built. Pure.
#pragma once

#include <string>
#include <string_view>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

[[nodiscard]] std::string diagnostics_to_json(const Diagnostics& diagnostics);

/// Empty for a text that is not such JSON.
[[nodiscard]] Diagnostics diagnostics_from_json(std::string_view text);

/// The findings of the link of one program.
struct LinkFindings {
  std::string output;   ///< the file that was linked, as the command names it
  std::string program;  ///< its name, which is that of CMake's target
  Diagnostics diagnostics;
};

[[nodiscard]] std::string link_findings_to_json(const LinkFindings& findings);

/// Empty for a text that is not such JSON.
[[nodiscard]] LinkFindings link_findings_from_json(std::string_view text);

}  // namespace ros2wasm
