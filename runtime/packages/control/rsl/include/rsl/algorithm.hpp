// Questions about containers.
#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

namespace rsl {

template <class CollectionT, class T>
[[nodiscard]] bool contains(const CollectionT& collection, const T& value) {
  return std::find(std::begin(collection), std::end(collection), value) != std::end(collection);
}

/// Takes a copy, which it sorts.
template <class CollectionT>
[[nodiscard]] bool is_unique(CollectionT collection) {
  std::sort(std::begin(collection), std::end(collection));
  return std::adjacent_find(std::begin(collection), std::end(collection)) == std::end(collection);
}

}  // namespace rsl
