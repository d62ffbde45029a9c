// Values by name, which nodes share; of a subtree, some names may stand for those of its parent. A
// tree and other threads may use it at once.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

#include "behaviortree_cpp/basic_types.h"

namespace BT {

class Blackboard {
 public:
  using Ptr = std::shared_ptr<Blackboard>;

  [[nodiscard]] static Ptr create(Ptr parent = {});

  /// Throws RuntimeError when there is none, or one that cannot be read so.
  template <typename T>
  [[nodiscard]] T get(const std::string& key) const {
    const Lock lock = locked();
    const Any* value = getAny(key);
    if (value == nullptr || value->empty()) {
      throw RuntimeError("Blackboard::get() error. Missing key [" + key + "]");
    }
    return read_as<T>(*value);
  }
  /// False when there is none.
  template <typename T>
  bool get(const std::string& key, T& value) const {
    const Lock lock = locked();
    const Any* found = getAny(key);
    if (found == nullptr || found->empty()) return false;
    value = read_as<T>(*found);
    return true;
  }
  template <typename T>
  void set(const std::string& key, const T& value) {
    if constexpr (std::is_same_v<T, Any>) {
      put(key, value);
    } else {
      put(key, Any(value));
    }
  }
  void unset(const std::string& key);

  /// Null when there is none. Where other threads write, it is good while the blackboard is locked.
  [[nodiscard]] const Any* getAny(const std::string& key) const;
  [[nodiscard]] std::vector<StringView> getKeys() const;
  void debugMessage() const;
  void clear();

  using Lock = std::unique_lock<std::recursive_mutex>;
  /// One lock for all blackboards of a tree.
  [[nodiscard]] Lock locked() const { return Lock(*mutex_); }

  /// Here `internal` is what `external` is for the parent.
  void addSubtreeRemapping(StringView internal, StringView external);
  /// Names of the parent stand for themselves.
  void enableAutoRemapping(bool remapping) { takes_all_ = remapping; }

 private:
  explicit Blackboard(Ptr parent)
      : parent_(std::move(parent)),
        mutex_(parent_ ? parent_->mutex_ : std::make_shared<std::recursive_mutex>()) {}

  void put(const std::string& key, Any value);
  /// The name that the parent has for it, or null when it is this one's.
  [[nodiscard]] const std::string* name_above(const std::string& key) const;

  Ptr parent_;
  std::shared_ptr<std::recursive_mutex> mutex_;
  bool takes_all_ = false;
  std::unordered_map<std::string, Any> values_;
  std::unordered_map<std::string, std::string> names_above_;
};

}  // namespace BT
