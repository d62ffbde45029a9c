// Entries of an index by name, as a map of them would be, without its cost: indexes are mostly
// sorted already. Pure.
#pragma once

#include <algorithm>
#include <vector>

namespace ros2wasm {

/// Sorts by `key`; of entries with the same key the last stays.
template <typename Entry, typename Key>
void put_in_order(std::vector<Entry>& entries, const Key& key) {
  const auto before = [&](const Entry& a, const Entry& b) { return key(a) < key(b); };
  const auto same = [&](const Entry& a, const Entry& b) { return key(a) == key(b); };
  if (!std::is_sorted(entries.begin(), entries.end(), before))
    std::stable_sort(entries.begin(), entries.end(), before);
  // unique() keeps the first of a run; from behind that is the last.
  entries.erase(entries.begin(), std::unique(entries.rbegin(), entries.rend(), same).base());
}

}  // namespace ros2wasm
