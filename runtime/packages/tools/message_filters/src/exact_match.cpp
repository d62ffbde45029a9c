// Messages with the same time.
#include <algorithm>

#include "message_filters/detail/match.hpp"

namespace message_filters::detail {

Outcome ExactMatch::add(size_t topic, int64_t stamp, Held message) {
  Outcome outcome;
  Row& row = rows_.try_emplace(stamp, topics_).first->second;
  row[topic] = std::move(message);
  if (std::all_of(row.begin(), row.end(), [](const Held& held) { return held != nullptr; })) {
    outcome.matched.push_back(std::move(row));
    rows_.erase(stamp);
    last_ = stamp;
    while (!rows_.empty() && rows_.begin()->first <= stamp) {
      outcome.dropped.push_back(std::move(rows_.begin()->second));
      rows_.erase(rows_.begin());
    }
  }
  while (queue_size_ > 0 && rows_.size() > queue_size_) {
    outcome.dropped.push_back(std::move(rows_.begin()->second));
    rows_.erase(rows_.begin());
  }
  return outcome;
}

}  // namespace message_filters::detail
