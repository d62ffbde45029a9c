// Launch arguments on the command line. Pure.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// `name:=value`, each; a later one of a name wins. R2W0902.
[[nodiscard]] Outcome<std::map<std::string, std::string>> launch_arguments_of(
    const std::vector<std::string>& given);

}  // namespace ros2wasm
