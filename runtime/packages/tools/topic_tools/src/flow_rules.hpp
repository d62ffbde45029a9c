// Which messages pass: by rate, by bandwidth, by count. Pure; times are those of the node's clock.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>

namespace topic_tools {

/// Lets a message through when a period has passed since the last one that went through.
class MessageThrottle {
 public:
  /// The first message is held back too, when it comes less than a period after the start.
  MessageThrottle(int64_t period_ns, int64_t start_ns)
      : period_ns_(period_ns), last_ns_(start_ns) {}

  /// Whether time is earlier than that of the last message, as when a bag starts again.
  bool is_back_in_time(int64_t now_ns) const { return last_ns_ > now_ns; }
  void restart(int64_t now_ns) { last_ns_ = now_ns; }

  bool passes(int64_t now_ns) {
    if (now_ns - last_ns_ < period_ns_) return false;
    last_ns_ = now_ns;
    return true;
  }

 private:
  int64_t period_ns_;
  int64_t last_ns_;
};

/// Lets messages through as long as those of the last `window_s` seconds have fewer bytes than
/// `most`.
class ByteThrottle {
 public:
  ByteThrottle(int64_t most, double window_s) : most_(most), window_s_(window_s) {}

  bool passes(double now_s, std::size_t bytes) {
    while (!sent_.empty() && sent_.front().time_s < now_s - window_s_) {
      sum_ -= sent_.front().bytes;
      sent_.pop_front();
    }
    if (sum_ >= most_) return false;
    sent_.push_back({now_s, static_cast<int64_t>(bytes)});
    sum_ += sent_.back().bytes;
    return true;
  }

 private:
  struct Sent {
    double time_s;
    int64_t bytes;
  };
  int64_t most_;
  double window_s_;
  std::deque<Sent> sent_;
  int64_t sum_ = 0;  ///< of the bytes in `sent_`
};

/// Drops the first `dropped` of every `of` messages.
class DropRule {
 public:
  DropRule(int64_t dropped, int64_t of) : dropped_(dropped), of_(of) {}

  bool passes() {
    const bool result = count_ >= dropped_;
    if (++count_ >= of_) count_ = 0;
    return result;
  }

 private:
  int64_t dropped_;
  int64_t of_;
  int64_t count_ = 0;
};

}  // namespace topic_tools
