// The nodes of site.json. Pure.
#pragma once

#include "bundler/render/site_plan.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {

void write_site_node(JsonWriter& json, const PlannedNode& planned);

/// Writes a program that nothing starts: the fields that are needed to run it.
void write_site_program(JsonWriter& json, const PlannedNode& planned);

/// The field `steps`.
void write_launch_steps(JsonWriter& json, const std::vector<LaunchStep>& steps);

/// The field `source`, if the place is known.
void write_site_source(JsonWriter& json, const SourceSpan& source);

}  // namespace ros2wasm
