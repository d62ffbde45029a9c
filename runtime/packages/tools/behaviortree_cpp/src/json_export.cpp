// See json_export.h.
#include "behaviortree_cpp/json_export.h"

namespace BT {
namespace {

using nlohmann::json;

/// A text, truth value or number; empty for all else.
Any plain_value(const json& source) {
  if (source.is_string()) return Any(source.get<std::string>());
  if (source.is_boolean()) return Any(source.get<bool>());
  if (source.is_number_unsigned()) return Any(source.get<uint64_t>());
  if (source.is_number_integer()) return Any(source.get<int64_t>());
  if (source.is_number()) return Any(source.get<double>());
  return Any();
}

}  // namespace

JsonExporter& JsonExporter::get() {
  static JsonExporter exporter;
  return exporter;
}

bool JsonExporter::toJson(const Any& any, json& destination) const {
  const auto writer = writers_.find(any.type());
  if (writer != writers_.end()) {
    writer->second(any, destination);
  } else if (any.isString()) {
    destination = any.cast<std::string>();
  } else if (any.type() == typeid(bool)) {
    destination = any.cast<bool>();
  } else if (any.type() == typeid(double) || any.type() == typeid(float)) {
    destination = any.cast<double>();
  } else if (any.isNumber()) {
    destination = any.cast<int64_t>();
  } else {
    return false;
  }
  return true;
}

JsonExporter::ExpectedEntry JsonExporter::fromJson(const json& source) const {
  if (source.is_null()) return nonstd::make_unexpected(std::string("json object is null"));
  if (Any plain = plain_value(source); !plain.empty()) {
    const std::type_index type = plain.type();
    return Entry(std::move(plain), TypeInfo(type));
  }
  const auto name = source.find("__type");
  if (!source.is_object() || name == source.end() || !name->is_string())
    return nonstd::make_unexpected(std::string("Missing field '__type'"));
  const auto type = types_.find(name->get<std::string>());
  if (type == types_.end())
    return nonstd::make_unexpected(std::string("Type not found in registered list"));
  return fromJson(source, type->second);
}

JsonExporter::ExpectedEntry JsonExporter::fromJson(const json& source, std::type_index type) const {
  const auto reader = readers_.find(type);
  try {
    if (reader != readers_.end()) return Entry(reader->second(source), TypeInfo(type));
  } catch (const json::exception& error) {
    return nonstd::make_unexpected(std::string(error.what()));
  }
  if (Any plain = plain_value(source); !plain.empty())
    return Entry(std::move(plain), TypeInfo(type));
  return nonstd::make_unexpected(std::string("Type not found in registered list"));
}

Any convertFromJSON(StringView json_text, std::type_index type) {
  const json source = json::parse(json_text, nullptr, false);
  if (source.is_discarded()) throw RuntimeError("not valid JSON: " + std::string(json_text));
  auto entry = JsonExporter::get().fromJson(source, type);
  if (!entry) throw RuntimeError(entry.error());
  return std::move(entry->first);
}

}  // namespace BT
