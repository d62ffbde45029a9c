// A check or a task as JSON: the form that both `ros2wasm check --json` and site.json have.
#pragma once

#include "workspace_schema/base/json_writer.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

/// The fields of an object that is open: `title` if it has one, `kind`, what it looks at, what must
/// be seen.
void write_check_aim(JsonWriter& json, const CheckEntry& check);

/// Those and `within_ms`.
void write_check_fields(JsonWriter& json, const CheckEntry& check);

/// The fields of a task but its checks: `title`, and the texts that it has.
void write_task_texts(JsonWriter& json, const TaskEntry& task);

}  // namespace ros2wasm
