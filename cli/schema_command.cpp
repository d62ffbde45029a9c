// `ros2wasm schema`: prints the JSON Schemas, for editors and for programs that read the events.
#include <memory>

#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "cli/embedded_texts.hpp"

namespace ros2wasm {

CommandBody schema_command(Arguments& arguments) {
  const auto which = std::make_shared<std::string>("workspace");
  std::vector<std::string> names;
  for (const EmbeddedText& schema : json_schemas()) names.emplace_back(schema.name);
  arguments.choice("--of", *which, names,
                   "workspace.yaml (the default), course.yaml, or the events of --json");
  arguments.examples({"ros2wasm schema > workspace.schema.json"});
  return [which](Context& context) {
    for (const EmbeddedText& schema : json_schemas()) {
      if (schema.name == *which) context.console.result_text(schema.text);
    }
    return 0;
  };
}

}  // namespace ros2wasm
