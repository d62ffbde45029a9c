// A manifest as JSON, with all defaults filled in: what `ros2wasm check --json` prints. Pure.
#pragma once

#include <string>

#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

class JsonWriter;

/// One line. Places are skipped; keys are those of workspace.yaml.
[[nodiscard]] std::string manifest_json(const Manifest& manifest);

/// A parameter value with its type kept: doubles always have a dot or an exponent, NaN and
/// infinities are texts as YAML writes them.
void write_parameter(JsonWriter& json, const ParameterValue& value);

}  // namespace ros2wasm
