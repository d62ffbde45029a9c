// Reads launch files in XML and YAML; those in Python are launch_python.hpp's. Pure: text in,
// entities out.
#pragma once

#include <string>
#include <string_view>

#include "bundler/launch/launch_entity.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

enum class LaunchLanguage { kXml, kYaml, kPython };

/// By the name's end, as launch has it: `.launch` alone may be XML or YAML, which the text decides.
[[nodiscard]] LaunchLanguage launch_language(std::string_view file, std::string_view text);

/// The entity `launch` with what stands in it. R2W0120 not XML, R2W0410 not a launch file.
[[nodiscard]] Outcome<LaunchEntity> read_xml_launch(std::string_view text, const std::string& file);

/// The same. R2W0101 and R2W0105 not YAML, R2W0410 not a launch file.
[[nodiscard]] Outcome<LaunchEntity> read_yaml_launch(std::string_view text,
                                                     const std::string& file);

}  // namespace ros2wasm
