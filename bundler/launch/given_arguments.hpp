// Launch arguments that somebody gives, against those that launch files declare. Pure.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "bundler/launch/launch_description.hpp"
#include "workspace_schema/base/diagnostic.hpp"

namespace ros2wasm {

/// By name; a later one wins.
[[nodiscard]] std::map<std::string, std::string> values_by_name(
    const std::vector<GivenArgument>& given);

/// Where they stand, for LaunchWorld.
[[nodiscard]] std::map<std::string, SourceSpan> places_by_name(
    const std::vector<GivenArgument>& given);

/// R2W0730 for each name that is not declared: natively they are passed over, which hides a slip.
/// `written` is how the giver writes a name with a value.
[[nodiscard]] Diagnostics undeclared_arguments(
    const std::vector<GivenArgument>& given, const std::vector<LaunchArgument>& declared,
    const std::function<std::string(const std::string& name, const std::string& value)>& written);
[[nodiscard]] Diagnostics undeclared_in_manifest(const std::vector<GivenArgument>& given,
                                                 const std::vector<LaunchArgument>& declared);

}  // namespace ros2wasm
