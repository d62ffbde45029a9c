// site.json: the only thing that the browser half knows of the native half. Pure.
#pragma once

#include <string>

#include "bundler/render/site_plan.hpp"
#include "bundler/site/site_names.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

/// Lists the plan's files; site.json itself is not among them.
[[nodiscard]] std::string site_json(const Manifest& manifest, const SitePlan& plan);

}  // namespace ros2wasm
