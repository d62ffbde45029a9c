// Which messages of several topics belong together. A message is only two things here: a pointer to
// anything, and a time in ns.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace message_filters::detail {

using Held = std::shared_ptr<const void>;
/// One for each topic; null where there is none.
using Row = std::vector<Held>;

/// The results of adding a message, in the order of reporting: sets that match, then dropped ones.
struct Outcome {
  std::vector<Row> matched;
  std::vector<Row> dropped;
};

struct Stamped {
  int64_t stamp;
  Held message;
};

/// Those with the same time.
class ExactMatch {
 public:
  /// Keeps `queue_size` times; 0: all.
  ExactMatch(size_t topics, uint32_t queue_size) : topics_(topics), queue_size_(queue_size) {}

  Outcome add(size_t topic, int64_t stamp, Held message);
  /// The time of the last match.
  [[nodiscard]] std::optional<int64_t> last() const { return last_; }

 private:
  size_t topics_;
  uint32_t queue_size_;
  std::map<int64_t, Row> rows_;
  std::optional<int64_t> last_;
};

/// Those at most `epsilon` ns apart.
class EpsilonMatch {
 public:
  EpsilonMatch(size_t topics, uint32_t queue_size, int64_t epsilon)
      : queue_size_(queue_size), epsilon_(epsilon), queues_(topics) {}

  Outcome add(size_t topic, int64_t stamp, Held message);

 private:
  [[nodiscard]] bool complete() const;

  uint32_t queue_size_;
  int64_t epsilon_;
  std::vector<std::deque<Stamped>> queues_;
};

/// The newest of each topic, whenever one of the fastest topic comes that is not late.
class LatestMatch {
 public:
  struct Smoothing {
    double rate = 0.9;
    double error = 0.3;
    /// So many times the mean error away from the mean rate is a change of the rate.
    double margin = 10.0;
  };

  explicit LatestMatch(size_t topics) : topics_(topics) {}

  /// One for all topics, or one for each.
  void set_smoothing(std::vector<Smoothing> each) { smoothing_ = std::move(each); }
  Outcome add(size_t topic, int64_t now, Held message);

 private:
  struct Topic {
    Held newest;
    Smoothing smoothing;
    int64_t previous = 0;
    std::optional<double> rate;
    std::optional<double> error;

    bool update(int64_t now);
    [[nodiscard]] bool is_late(int64_t now) const;
  };
  [[nodiscard]] std::optional<size_t> pivot(int64_t now) const;

  std::vector<Topic> topics_;
  std::vector<Smoothing> smoothing_;
};

/// Sets of one message of each topic whose times span as little as may be, none used twice and none
/// out of order. Every set contains the pivot, a message that is the latest of the first set that
/// could be made; a set is passed on when no message yet to come could make a better one with it.
class ApproximateMatch {
 public:
  ApproximateMatch(size_t topics, uint32_t queue_size) : queue_size_(queue_size), topics_(topics) {}

  Outcome add(size_t topic, int64_t stamp, Held message);

  /// How much longer a later set must be worth waiting for.
  void set_age_penalty(double penalty) { age_penalty_ = penalty; }
  /// Messages of a topic come at least so many ns apart.
  void set_lower_bound(size_t topic, int64_t bound) { topics_.at(topic).lower_bound = bound; }
  void set_longest_interval(int64_t longest) { longest_ = longest; }

 private:
  struct Topic {
    std::deque<Stamped> queue;
    /// How many at the front of the queue the search has left behind.
    size_t passed = 0;
    /// A message that was dropped could have made a better set.
    bool dropped = false;
    int64_t lower_bound = 0;
    bool warned = false;

    [[nodiscard]] bool has_head() const { return passed < queue.size(); }
    [[nodiscard]] const Stamped& head() const { return queue[passed]; }
  };
  /// A topic and a time.
  struct Boundary {
    size_t topic;
    int64_t stamp;
  };
  struct Interval {
    Boundary start;
    Boundary end;
  };
  struct Candidate {
    Row row;
    int64_t start;
    int64_t end;
    Boundary pivot;
  };

  void check_order(size_t topic);
  [[nodiscard]] bool complete() const;
  void search(std::vector<Row>& matched);
  /// True when the search goes on with the next message of the earliest topic.
  bool find_candidate(const Interval& here);
  void take_candidate(const Interval& here, Boundary pivot);
  void publish(std::vector<Row>& matched);
  /// Whether the candidate is the best even if every topic's next message came as early as it may.
  bool is_best_of_all();
  void forget_passed();
  /// From the earliest to the latest of the topics' next messages.
  [[nodiscard]] Interval interval() const;
  /// The time of a topic's next message, or the earliest that it can have.
  [[nodiscard]] int64_t earliest(const Topic& topic) const;
  /// Is a set that ends at `end` too late to be better than the candidate, if it starts at `start`?
  [[nodiscard]] bool is_worse(int64_t start, int64_t end) const;

  uint32_t queue_size_;
  std::vector<Topic> topics_;
  std::optional<Candidate> candidate_;
  double age_penalty_ = 0.1;
  int64_t longest_ = std::numeric_limits<int64_t>::max();
};

}  // namespace message_filters::detail
