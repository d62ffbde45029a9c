// See schema_validator.hpp.
#include "unit/workspace_schema/schema_validator.hpp"

#include <algorithm>
#include <regex>
#include <set>
#include <stdexcept>

#include "workspace_schema/base/yaml_scalar.hpp"

namespace ros2wasm::testing {
namespace {

const std::set<std::string>& known_keywords() {
  static const std::set<std::string> kKnown{
      "$schema",       "$id",           "$defs",      "$ref",
      "title",         "description",   "type",       "const",
      "enum",          "pattern",       "maxLength",  "minItems",
      "items",         "required",      "properties", "additionalProperties",
      "propertyNames", "minProperties", "anyOf",      "dependentRequired"};
  return kKnown;
}

bool has_type(const YamlNode& instance, const std::string& type) {
  if (type == "object") return instance.kind == YamlKind::kMap;
  if (type == "array") return instance.kind == YamlKind::kSequence;
  if (instance.kind == YamlKind::kMap || instance.kind == YamlKind::kSequence) return false;
  const YamlValue value = scalar_value(instance);
  // Tags of other languages are not seen by editors: the value is a text for them.
  if (type == "string") {
    return std::holds_alternative<std::string>(value) ||
           std::holds_alternative<YamlUnknownTag>(value);
  }
  if (type == "boolean") return std::holds_alternative<bool>(value);
  if (type == "number") {
    return std::holds_alternative<double>(value) || std::holds_alternative<std::int64_t>(value) ||
           std::holds_alternative<YamlIntegerTooLarge>(value);
  }
  if (type == "null") return std::holds_alternative<std::monostate>(value);
  throw std::logic_error("unknown type " + type);
}

bool equals(const YamlNode& instance, const JsonValue& wanted) {
  const YamlValue value = scalar_value(instance);
  if (const std::string* text = wanted.string()) {
    const auto* found = std::get_if<std::string>(&value);
    return instance.kind == YamlKind::kScalar && found != nullptr && *found == *text;
  }
  const auto* number = std::get_if<std::int64_t>(&value);
  return wanted.integer().has_value() && number != nullptr && *number == *wanted.integer();
}

std::size_t utf8_length(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

}  // namespace

const JsonValue& SchemaValidator::target_of(const std::string& reference) const {
  const std::string prefix = "#/$defs/";
  const JsonValue* definitions = root_.find("$defs");
  const JsonValue* target = reference.starts_with(prefix) && definitions != nullptr
                                ? definitions->find(reference.substr(prefix.size()))
                                : nullptr;
  if (target == nullptr) throw std::logic_error("no target for " + reference);
  return *target;
}

std::string SchemaValidator::first_error(const YamlNode& instance) const {
  return error(root_, instance, "$");
}

bool SchemaValidator::valid(const JsonValue& schema, const YamlNode& instance) const {
  return error(schema, instance, "").empty();
}

std::string SchemaValidator::error(const JsonValue& schema, const YamlNode& instance,
                                   const std::string& path) const {
  if (schema.boolean().has_value()) return *schema.boolean() ? "" : path + ": nothing is allowed";
  for (const auto& [keyword, argument] : schema.members()) {
    if (!known_keywords().contains(keyword)) throw std::logic_error("unknown keyword " + keyword);
    if (keyword == "$ref") {
      const std::string inner = error(target_of(*argument.string()), instance, path);
      if (!inner.empty()) return inner;
    } else if (keyword == "type") {
      const auto& types = argument.items();
      const bool good = argument.string() != nullptr
                            ? has_type(instance, *argument.string())
                            : std::any_of(types.begin(), types.end(), [&](const JsonValue& type) {
                                return has_type(instance, *type.string());
                              });
      if (!good) return path + ": type";
    } else if (keyword == "const") {
      if (!equals(instance, argument)) return path + ": const";
    } else if (keyword == "enum") {
      const auto& values = argument.items();
      if (std::none_of(values.begin(), values.end(),
                       [&](const JsonValue& v) { return equals(instance, v); })) {
        return path + ": enum";
      }
    } else if (keyword == "pattern" && has_type(instance, "string")) {
      if (!std::regex_search(instance.text, std::regex(*argument.string())))
        return path + ": pattern";
    } else if (keyword == "maxLength" && has_type(instance, "string")) {
      if (utf8_length(instance.text) > *argument.unsigned_integer()) return path + ": maxLength";
    } else if (keyword == "minItems" && instance.kind == YamlKind::kSequence) {
      if (instance.items.size() < *argument.unsigned_integer()) return path + ": minItems";
    } else if (keyword == "items") {
      for (const YamlNode& item : instance.items) {
        if (!valid(argument, item)) return path + ": items";
      }
    } else if (keyword == "anyOf") {
      const auto& choices = argument.items();
      if (std::none_of(choices.begin(), choices.end(),
                       [&](const JsonValue& choice) { return valid(choice, instance); })) {
        return path + ": anyOf";
      }
    }
  }
  if (instance.kind == YamlKind::kMap && !valid_object(schema, instance)) return path + ": object";
  return {};
}

bool SchemaValidator::valid_object(const JsonValue& schema, const YamlNode& instance) const {
  const auto entry_of = [&](const std::string& key) {
    return std::any_of(instance.entries.begin(), instance.entries.end(),
                       [&](const YamlEntry& e) { return e.key == key; });
  };
  if (const JsonValue* required = schema.find("required")) {
    for (const JsonValue& key : required->items()) {
      if (!entry_of(*key.string())) return false;
    }
  }
  if (const JsonValue* dependent = schema.find("dependentRequired")) {
    for (const auto& [key, needs] : dependent->members()) {
      for (const JsonValue& need : needs.items())
        if (entry_of(key) && !entry_of(*need.string())) return false;
    }
  }
  if (const JsonValue* least = schema.find("minProperties")) {
    if (instance.entries.size() < *least->unsigned_integer()) return false;
  }
  const JsonValue* properties = schema.find("properties");
  const JsonValue* others = schema.find("additionalProperties");
  const JsonValue* names = schema.find("propertyNames");
  return std::all_of(instance.entries.begin(), instance.entries.end(), [&](const YamlEntry& entry) {
    const YamlNode name{.kind = YamlKind::kScalar, .quoted = true, .text = entry.key};
    if (names != nullptr && !valid(*names, name)) return false;
    const JsonValue* own = properties == nullptr ? nullptr : properties->find(entry.key);
    if (own != nullptr) return valid(*own, entry.value);
    return others == nullptr || valid(*others, entry.value);
  });
}

}  // namespace ros2wasm::testing
