// See web_manifest.hpp.
#include "bundler/render/web_manifest.hpp"

#include "workspace_schema/base/json_writer.hpp"
#include "workspace_schema/base/replaced_text.hpp"

namespace ros2wasm {

std::string web_manifest(std::string_view manifest, std::string_view title) {
  return with_replaced(manifest, "\"ros2wasm\"", json_quoted(title));
}

}  // namespace ros2wasm
