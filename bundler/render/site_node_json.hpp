// The nodes of site.json. Pure.
#pragma once

#include "bundler/plan/site_plan.hpp"
#include "workspace_schema/json_writer.hpp"

namespace ros2wasm {

void write_site_node(JsonWriter& json, const PlannedNode& planned);

/// Of a program that nothing starts: what is needed to run it.
void write_site_program(JsonWriter& json, const PlannedNode& planned);

/// The field `steps`.
void write_launch_steps(JsonWriter& json, const std::vector<LaunchStep>& steps);

/// The field `source`, if the place is known.
void write_site_source(JsonWriter& json, const SourceSpan& source);

}  // namespace ros2wasm
