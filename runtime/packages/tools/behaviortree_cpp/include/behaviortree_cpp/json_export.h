// Values of ports and blackboards as JSON, for types that user code describes with
// BT_JSON_CONVERTER.
#pragma once

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <typeindex>
#include <utility>
#include <vector>

#include "behaviortree_cpp/basic_types.h"

namespace BT {

/// The converters of a program. A converted value has its type's name in the field `__type`.
class JsonExporter {
 public:
  using Entry = std::pair<Any, TypeInfo>;
  using ExpectedEntry = nonstd::expected<Entry, std::string>;

  static JsonExporter& get();

  /// False when the type has no converter. Texts, numbers and truth values have one.
  bool toJson(const Any& any, nlohmann::json& destination) const;
  template <typename T>
  nlohmann::json toJson(const T& value) const {
    nlohmann::json result;
    toJson(Any(value), result);
    return result;
  }

  /// The type is the one that `__type` names, or a plain one.
  ExpectedEntry fromJson(const nlohmann::json& source) const;
  ExpectedEntry fromJson(const nlohmann::json& source, std::type_index type) const;
  template <typename T>
  Expected<T> fromJson(const nlohmann::json& source) const {
    auto entry = fromJson(source, typeid(T));
    if (!entry) return nonstd::make_unexpected(entry.error());
    return entry->first.template tryCast<T>();
  }

  /// For a type with to_json() and from_json() of nlohmann; vectors of it too.
  template <typename T>
  void addConverter() {
    addConverter<T>(std::function<void(nlohmann::json&, const T&)>(
        [](nlohmann::json& destination, const T& value) { destination = value; }));
    addConverter<T>(std::function<void(const nlohmann::json&, T&)>(
        [](const nlohmann::json& source, T& value) { source.get_to(value); }));
    addConverter<std::vector<T>>(std::function<void(nlohmann::json&, const std::vector<T>&)>(
                                     [](nlohmann::json& destination, const std::vector<T>& values) {
                                       destination = values;
                                     }),
                                 false);
    addConverter<std::vector<T>>(std::function<void(const nlohmann::json&, std::vector<T>&)>(
        [](const nlohmann::json& source, std::vector<T>& values) { source.get_to(values); }));
  }
  template <typename T>
  void addConverter(std::function<void(nlohmann::json&, const T&)> to_json, bool add_type = true) {
    writers_[typeid(T)] = [to_json = std::move(to_json), add_type](const Any& any,
                                                                   nlohmann::json& destination) {
      to_json(destination, any.cast<T>());
      if (add_type) destination["__type"] = demangle(typeid(T));
    };
  }
  template <typename T>
  void addConverter(std::function<void(const nlohmann::json&, T&)> from_json) {
    readers_[typeid(T)] = [from_json = std::move(from_json)](const nlohmann::json& source) {
      T value{};
      from_json(source, value);
      return Any(std::move(value));
    };
    types_.insert_or_assign(demangle(typeid(T)), std::type_index(typeid(T)));
  }

 private:
  std::map<std::type_index, std::function<void(const Any&, nlohmann::json&)>> writers_;
  std::map<std::type_index, std::function<Any(const nlohmann::json&)>> readers_;
  std::map<std::string, std::type_index> types_;
};

template <typename T>
void RegisterJsonDefinition() {
  JsonExporter::get().addConverter<T>();
}

}  // namespace BT

/// Followed by a body that calls `add_field("name", &value.name)` for each field.
#define BT_JSON_CONVERTER(Type, value)                                                  \
  template <typename AddFieldT>                                                         \
  void bt_json_fields(Type& value, AddFieldT& add_field);                               \
  inline void to_json(nlohmann::json& destination, const Type& source) {                \
    auto write = [&](const char* name, auto* field) { destination[name] = *field; };    \
    bt_json_fields(const_cast<Type&>(source), write);                                   \
  }                                                                                     \
  inline void from_json(const nlohmann::json& source, Type& destination) {              \
    auto read = [&](const char* name, auto* field) { source.at(name).get_to(*field); }; \
    bt_json_fields(destination, read);                                                  \
  }                                                                                     \
  template <typename AddFieldT>                                                         \
  void bt_json_fields(Type& value, AddFieldT& add_field)
