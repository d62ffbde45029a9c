// Sets of messages whose times are as close to each other as may be.
#include <algorithm>
#include <cinttypes>

#include "message_filters/detail/match.hpp"
#include "rcutils/logging_macros.h"

namespace message_filters::detail {

Outcome ApproximateMatch::add(size_t topic, int64_t stamp, Held message) {
  Outcome outcome;
  Topic& here = topics_[topic];
  const bool had_head = here.has_head();
  here.queue.push_back({stamp, std::move(message)});
  if (had_head) {
    check_order(topic);
  } else {
    search(outcome.matched);
  }
  if (here.queue.size() > queue_size_) {
    forget_passed();
    here.queue.pop_front();
    here.dropped = true;
    if (candidate_) {
      candidate_.reset();
      search(outcome.matched);
    }
  }
  return outcome;
}

void ApproximateMatch::check_order(size_t topic) {
  Topic& here = topics_[topic];
  const int64_t gap = here.queue.back().stamp - here.queue[here.queue.size() - 2].stamp;
  if (here.warned || gap >= here.lower_bound) {
    return;
  }
  here.warned = true;
  if (gap < 0) {
    RCUTILS_LOG_WARN("Messages of type %d arrived out of order (will print only once)",
                     static_cast<int>(topic));
  } else {
    RCUTILS_LOG_WARN("Messages of type %d arrived closer (%" PRId64
                     ") than the lower bound you provided (%" PRId64 ") (will print only once)",
                     static_cast<int>(topic), gap, here.lower_bound);
  }
}

bool ApproximateMatch::complete() const {
  return std::all_of(topics_.begin(), topics_.end(), [](const Topic& t) { return t.has_head(); });
}

void ApproximateMatch::search(std::vector<Row>& matched) {
  while (complete()) {
    const Interval here = interval();
    for (size_t i = 0; i < topics_.size(); ++i) {
      if (i != here.end.topic) {
        topics_[i].dropped = false;
      }
    }
    if (!find_candidate(here)) {
      topics_[here.start.topic].queue.pop_front();
      continue;
    }
    ++topics_[here.start.topic].passed;
    if (here.start.topic == candidate_->pivot.topic ||
        is_worse(candidate_->pivot.stamp, here.end.stamp) || (!complete() && is_best_of_all())) {
      publish(matched);
    }
  }
}

bool ApproximateMatch::find_candidate(const Interval& here) {
  if (candidate_) {
    if (!is_worse(here.start.stamp, here.end.stamp)) {
      take_candidate(here, candidate_->pivot);
    }
    return true;
  }
  if (here.end.stamp - here.start.stamp > longest_ || topics_[here.end.topic].dropped) {
    return false;
  }
  take_candidate(here, here.end);
  return true;
}

void ApproximateMatch::take_candidate(const Interval& here, Boundary pivot) {
  Row row;
  for (Topic& topic : topics_) {
    row.push_back(topic.head().message);
    topic.queue.erase(topic.queue.begin(),
                      topic.queue.begin() + static_cast<std::ptrdiff_t>(topic.passed));
    topic.passed = 0;
  }
  candidate_ = Candidate{std::move(row), here.start.stamp, here.end.stamp, pivot};
}

void ApproximateMatch::publish(std::vector<Row>& matched) {
  matched.push_back(std::move(candidate_->row));
  candidate_.reset();
  forget_passed();
  for (Topic& topic : topics_) {
    topic.queue.pop_front();  // it was in the candidate
  }
}

bool ApproximateMatch::is_best_of_all() {
  std::vector<size_t> before;
  for (const Topic& topic : topics_) {
    before.push_back(topic.passed);
  }
  for (;;) {
    const Interval here = interval();
    if (is_worse(candidate_->pivot.stamp, here.end.stamp)) {
      return true;
    }
    if (!is_worse(here.start.stamp, here.end.stamp)) {
      for (size_t i = 0; i < topics_.size(); ++i) {
        topics_[i].passed = before[i];
      }
      return false;
    }
    ++topics_[here.start.topic].passed;
  }
}

void ApproximateMatch::forget_passed() {
  for (Topic& topic : topics_) {
    topic.passed = 0;
  }
}

ApproximateMatch::Interval ApproximateMatch::interval() const {
  Interval found{{0, earliest(topics_[0])}, {0, earliest(topics_[0])}};
  for (size_t i = 1; i < topics_.size(); ++i) {
    const int64_t stamp = earliest(topics_[i]);
    if (stamp < found.start.stamp) {
      found.start = {i, stamp};
    }
    if (stamp >= found.end.stamp) {
      found.end = {i, stamp};
    }
  }
  return found;
}

int64_t ApproximateMatch::earliest(const Topic& topic) const {
  if (topic.has_head()) {
    return topic.head().stamp;
  }
  return std::max(topic.queue.back().stamp + topic.lower_bound, candidate_->pivot.stamp);
}

bool ApproximateMatch::is_worse(int64_t start, int64_t end) const {
  return static_cast<double>(end - candidate_->end) * (1.0 + age_penalty_) >=
         static_cast<double>(start - candidate_->start);
}

}  // namespace message_filters::detail
