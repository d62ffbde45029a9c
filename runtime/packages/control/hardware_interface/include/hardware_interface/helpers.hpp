// Lists and maps as sets. This file needs no ROS.
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace ros2_control {

template <typename T>
[[nodiscard]] auto get_item_iterator(const std::vector<T>& container, const T& item) {
  return std::find(container.cbegin(), container.cend(), item);
}
template <typename KeyT, typename ValueT>
[[nodiscard]] auto get_item_iterator(const std::map<KeyT, ValueT>& container, const KeyT& item) {
  return container.find(item);
}
template <typename KeyT, typename ValueT>
[[nodiscard]] auto get_item_iterator(const std::unordered_map<KeyT, ValueT>& container,
                                     const KeyT& item) {
  return container.find(item);
}

template <typename Container, typename T>
[[nodiscard]] bool has_item(const Container& container, const T& item) {
  return get_item_iterator(container, item) != container.cend();
}

template <typename T>
void add_item(std::vector<T>& vector, const T& item) {
  if (!has_item(vector, item)) {
    vector.push_back(item);
  }
}
template <typename T>
void add_items(std::vector<T>& vector, const std::vector<T>& items) {
  for (const T& item : items) {
    add_item(vector, item);
  }
}

/// True when the item was there.
template <typename Container>
[[nodiscard]] bool remove_item(Container& container, typename Container::const_reference item) {
  const auto at = get_item_iterator(container, item);
  if (at == container.cend()) {
    return false;
  }
  container.erase(at);
  return true;
}

template <typename Container>
[[nodiscard]] bool has_any_item(const Container& container,
                                const std::vector<typename Container::key_type>& items) {
  return std::any_of(items.begin(), items.end(),
                     [&container](const auto& item) { return has_item(container, item); });
}
template <typename T>
[[nodiscard]] bool has_any_item(const std::vector<T>& container, const std::vector<T>& items) {
  return std::any_of(items.begin(), items.end(),
                     [&container](const T& item) { return has_item(container, item); });
}
template <typename Container>
[[nodiscard]] bool has_all_items(const Container& container,
                                 const std::vector<typename Container::key_type>& items) {
  return std::all_of(items.begin(), items.end(),
                     [&container](const auto& item) { return has_item(container, item); });
}
template <typename T>
[[nodiscard]] bool has_all_items(const std::vector<T>& container, const std::vector<T>& items) {
  return std::all_of(items.begin(), items.end(),
                     [&container](const T& item) { return has_item(container, item); });
}

template <typename Container>
[[nodiscard]] bool is_unique(Container container) {
  std::sort(container.begin(), container.end());
  return std::adjacent_find(container.cbegin(), container.cend()) == container.cend();
}

inline std::string strip(const std::string& str) {
  constexpr char kWhitespace[] = " \t\n\r\f\v";
  const auto first = str.find_first_not_of(kWhitespace);
  return first == std::string::npos
             ? std::string()
             : str.substr(first, str.find_last_not_of(kWhitespace) - first + 1);
}

}  // namespace ros2_control
