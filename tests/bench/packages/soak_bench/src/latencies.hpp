// The measurements of one stream of messages between two reports: how many came, how long they took.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <vector>

/// The time of day in ns: the same for all nodes of a site.
inline std::int64_t now_ns()
{
  using std::chrono::nanoseconds;
  return std::chrono::duration_cast<nanoseconds>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// Prints one JSON line: how many the sender of a stream has published in a period.
inline void report_published(const char * stream, std::uint64_t published)
{
  std::printf("{\"soak\": \"%s\", \"published\": %llu}\n", stream, static_cast<unsigned long long>(published));
  std::fflush(stdout);
}

struct Latencies
{
  std::vector<double> us;
  /// How many were sent, as far as the receiver can tell.
  std::uint64_t sent = 0;

  void add(std::int64_t since_ns) {us.push_back(static_cast<double>(now_ns() - since_ns) / 1e3);}

  /// Prints one JSON line and begins again.
  void report(const char * stream)
  {
    std::sort(us.begin(), us.end());
    const auto at = [this](std::size_t share) {return us.empty() ? 0.0 : us[us.size() * share / 100];};
    std::printf(
      "{\"soak\": \"%s\", \"sent\": %llu, \"came\": %zu, \"p50_us\": %.1f, \"p99_us\": %.1f}\n", stream,
      static_cast<unsigned long long>(sent), us.size(), at(50), at(99));
    std::fflush(stdout);
    us.clear();
    sent = 0;
  }
};
