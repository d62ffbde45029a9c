// Messages at most so far apart.
#include <algorithm>

#include "message_filters/detail/match.hpp"

namespace message_filters::detail {

bool EpsilonMatch::complete() const {
  return std::none_of(queues_.begin(), queues_.end(),
                      [](const auto& queue) { return queue.empty(); });
}

Outcome EpsilonMatch::add(size_t topic, int64_t stamp, Held message) {
  Outcome outcome;
  queues_[topic].push_back({stamp, std::move(message)});
  if (!complete()) {
    if (queues_[topic].size() > queue_size_) {
      queues_[topic].pop_front();
    }
    return outcome;
  }
  while (complete()) {
    const auto earlier = [](const auto& a, const auto& b) {
      return a.front().stamp < b.front().stamp;
    };
    const int64_t first = std::min_element(queues_.begin(), queues_.end(), earlier)->front().stamp;
    const auto is_near = [&](const auto& queue) { return queue.front().stamp - first <= epsilon_; };
    if (std::all_of(queues_.begin(), queues_.end(), is_near)) {
      Row row;
      for (auto& queue : queues_) {
        row.push_back(std::move(queue.front().message));
      }
      outcome.matched.push_back(std::move(row));
    }
    for (auto& queue : queues_) {
      if (is_near(queue)) {
        queue.pop_front();
      }
    }
  }
  return outcome;
}

}  // namespace message_filters::detail
