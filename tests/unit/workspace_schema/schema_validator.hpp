// A JSON Schema validator for the keywords that workspace.schema.json uses, over our own YAML
// trees. It fails on any keyword that it does not know, so that the schema cannot say something
// that no test looks at.
#pragma once

#include <string>

#include "workspace_schema/base/json_reader.hpp"
#include "workspace_schema/base/yaml_reader.hpp"

namespace ros2wasm::testing {

class SchemaValidator {
 public:
  explicit SchemaValidator(const JsonValue& root) : root_(root) {}

  /// Empty when the instance is valid, else the path of the first thing that is wrong. Throws
  /// std::logic_error for a schema that uses what this does not know.
  [[nodiscard]] std::string first_error(const YamlNode& instance) const;

 private:
  [[nodiscard]] bool valid(const JsonValue& schema, const YamlNode& instance) const;
  [[nodiscard]] bool valid_object(const JsonValue& schema, const YamlNode& instance) const;
  [[nodiscard]] std::string error(const JsonValue& schema, const YamlNode& instance,
                                  const std::string& path) const;
  [[nodiscard]] const JsonValue& target_of(const std::string& reference) const;

  const JsonValue& root_;
};

}  // namespace ros2wasm::testing
