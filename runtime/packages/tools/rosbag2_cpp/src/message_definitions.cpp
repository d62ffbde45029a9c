// The definitions of the types that a program uses, in the form that bags need.
#include <map>
#include <mutex>
#include <string_view>

#include "rclcpp/detail/type_use.hpp"
#include "rosbag2_cpp/detail/known_type.hpp"
#include "rosbag2_cpp/message_definitions/local_message_definition_source.hpp"

namespace rosbag2_cpp {
namespace {

using ros2wasm_typesupport::TypeInfo;
using Types = std::map<std::string, const TypeInfo*>;

struct KnownTypes {
  std::mutex mutex;
  Types types;
};

KnownTypes& known_types() {
  static KnownTypes all;
  return all;
}

void collect(const TypeInfo& type, Types& into) {
  for (size_t i = 0; i < type.field_count; ++i) {
    const TypeInfo* const nested = type.fields[i].nested;
    if (nested != nullptr && into.emplace(nested->type_name, nested).second) {
      collect(*nested, into);
    }
  }
}

/// "geometry_msgs/Point" for "geometry_msgs/msg/Point".
std::string short_name(const std::string& type) {
  return type.substr(0, type.find('/')) + type.substr(type.rfind('/'));
}

/// Parts of services and actions have no text of their own.
const char* text_of(const TypeInfo& type) {
  if (std::string_view(type.encoding) != "msg") {
    throw DefinitionNotFoundError(type.type_name);
  }
  return type.source;
}

}  // namespace

namespace detail {

void know_type(const TypeInfo* info) {
  if (info != nullptr) {
    KnownTypes& all = known_types();
    const std::lock_guard<std::mutex> lock(all.mutex);
    all.types[info->type_name] = info;
  }
}

const TypeInfo* find_known_type(const std::string& name) {
  {
    KnownTypes& all = known_types();
    const std::lock_guard<std::mutex> lock(all.mutex);
    const auto found = all.types.find(name);
    if (found != all.types.end()) {
      return found->second;
    }
  }
  return rclcpp::detail::find_used_type(name);
}

}  // namespace detail

rosbag2_storage::MessageDefinition LocalMessageDefinitionSource::get_full_text(
    const std::string& root_type) {
  const TypeInfo* const root = detail::find_known_type(root_type);
  if (root == nullptr) {
    throw DefinitionNotFoundError(root_type);
  }
  std::string text = text_of(*root);
  Types inside;
  collect(*root, inside);
  for (const auto& [name, type] : inside) {
    constexpr size_t kLine = 80;
    text += "\n" + std::string(kLine, '=') + "\nMSG: " + short_name(name) + "\n" + text_of(*type);
  }
  return {root_type, "ros2msg", text, ""};
}

}  // namespace rosbag2_cpp
