// The newest messages, at the rate of the fastest topic.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "message_filters/detail/match.hpp"

namespace message_filters::detail {
namespace {

double seconds(int64_t nanoseconds) {
  return static_cast<double>(nanoseconds) * 1e-9;
}

}  // namespace

/// False when no time has passed.
bool LatestMatch::Topic::update(int64_t now) {
  if (now <= previous) {
    return false;
  }
  const double current = 1.0 / seconds(now - previous);
  previous = now;
  const double away = rate ? std::abs(*rate - current) : 0.0;
  if (!rate || (error && away > smoothing.margin * *error)) {
    rate = current;
    error.reset();
    return true;
  }
  error = error ? smoothing.error * away + (1.0 - smoothing.error) * *error : away;
  rate = smoothing.rate * current + (1.0 - smoothing.rate) * *rate;
  return true;
}

bool LatestMatch::Topic::is_late(int64_t now) const {
  return now != previous && error &&
         *rate - 1.0 / seconds(now - previous) > smoothing.margin * *error;
}

std::optional<size_t> LatestMatch::pivot(int64_t now) const {
  std::vector<size_t> order(topics_.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    return topics_[a].rate.value_or(0.0) > topics_[b].rate.value_or(0.0);
  });
  const auto found = std::find_if(order.begin(), order.end(), [&](size_t each) {
    return topics_[each].rate && !topics_[each].is_late(now);
  });
  return found == order.end() ? std::nullopt : std::optional(*found);
}

Outcome LatestMatch::add(size_t topic, int64_t now, Held message) {
  Topic& here = topics_[topic];
  const bool first = here.newest == nullptr;
  here.newest = std::move(message);
  if (first) {
    if (!smoothing_.empty()) {
      here.smoothing = smoothing_.size() == topics_.size() ? smoothing_[topic] : smoothing_.front();
    }
    here.previous = now;
    return {};
  }
  if (!here.update(now) || pivot(now) != topic) {
    return {};
  }
  Row row;
  for (const Topic& each : topics_) {
    if (each.newest == nullptr) {
      return {};
    }
    row.push_back(each.newest);
  }
  return {{std::move(row)}, {}};
}

}  // namespace message_filters::detail
