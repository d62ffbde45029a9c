// `ros2wasm version`.
#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {

CommandBody version_command(Arguments&) {
  return [](Context& context) {
    if (context.json) {
      JsonWriter json;
      json.begin_object().field("name", "ros2wasm").field("version", ROS2WASM_VERSION);
      json.field_integer("manifest_schema", 1).end_object();
      context.console.result(json.text());
    } else {
      context.console.result("ros2wasm " ROS2WASM_VERSION);
    }
    return 0;
  };
}

}  // namespace ros2wasm
