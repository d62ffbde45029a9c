// See interfaces_json.hpp.
#include "bundler/render/interfaces_json.hpp"

#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {

std::string interfaces_json(const InterfaceTexts& interfaces) {
  JsonWriter json;
  json.begin_object();
  for (const auto& [type, text] : interfaces) json.field(type, text);
  json.end_object();
  return json.text() + "\n";
}

}  // namespace ros2wasm
