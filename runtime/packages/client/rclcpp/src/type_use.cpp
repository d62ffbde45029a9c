// Which interface types a node uses just now.
#include "rclcpp/detail/type_use.hpp"

#include <map>
#include <mutex>
#include <utility>

namespace rclcpp {
namespace detail {
namespace {

struct Uses {
  std::mutex mutex;
  /// By node and hash.
  std::multimap<std::pair<int32_t, std::string>, const ros2wasm_typesupport::TypeInfo*> types;
};

std::shared_ptr<Uses> uses() {
  static const auto instance = std::make_shared<Uses>();
  return instance;
}

}  // namespace

std::shared_ptr<void> use_type(int32_t node_id, const char* type_hash,
                               const ros2wasm_typesupport::TypeInfo* info) {
  if (info == nullptr) {
    return nullptr;
  }
  const auto all = uses();
  const std::lock_guard<std::mutex> lock(all->mutex);
  const auto entry = all->types.emplace(std::make_pair(node_id, std::string(type_hash)), info);
  return {nullptr, [all, entry](void*) {
            const std::lock_guard<std::mutex> end_lock(all->mutex);
            all->types.erase(entry);
          }};
}

const ros2wasm_typesupport::TypeInfo* find_used_type(int32_t node_id,
                                                     const std::string& type_hash) {
  const auto all = uses();
  const std::lock_guard<std::mutex> lock(all->mutex);
  const auto found = all->types.find({node_id, type_hash});
  return found == all->types.end() ? nullptr : found->second;
}

const ros2wasm_typesupport::TypeInfo* find_used_type(const std::string& type_name) {
  const auto all = uses();
  const std::lock_guard<std::mutex> lock(all->mutex);
  for (const auto& [use, info] : all->types) {
    if (info->type_name == type_name) {
      return info;
    }
  }
  return nullptr;
}

}  // namespace detail
}  // namespace rclcpp
