// A check as JSON: the form that both `ros2wasm check --json` and site.json have.
#pragma once

#include "workspace_schema/json_writer.hpp"
#include "workspace_schema/manifest.hpp"

namespace ros2wasm {

/// The fields of an object that is open: `kind`, what it looks at, what must be seen, `within_ms`.
void write_check_fields(JsonWriter& json, const CheckEntry& check);

}  // namespace ros2wasm
