// See read_in_parts.hpp.
#include "bundler/channel/read_in_parts.hpp"

#include <algorithm>
#include <iterator>

#include "bundler/io/worker_pool.hpp"

namespace ros2wasm {
namespace {

constexpr std::size_t kSmallestPart = 16;  ///< names; below it a thread costs more than it brings
constexpr std::size_t kMostParts = 32;     ///< more than threads, as names have few or many records

struct Part {
  SpecTable specs{false};
  RepoIndex index;
  Outcome<Done> outcome = Done{};
};

}  // namespace

Outcome<Done> read_in_parts(std::size_t count, SpecTable& specs, RepoIndex& into,
                            const ReadPart& read) {
  const std::size_t parts = std::min(count / kSmallestPart, kMostParts);
  if (specs.checks() || parts < 2) return read(0, count, specs, into);
  std::vector<Part> all(parts);
  {
    WorkerPool pool;
    for (std::size_t i = 0; i < parts; ++i) {
      pool.add([&, i] {
        Part& part = all[i];
        part.outcome = read(count * i / parts, count * (i + 1) / parts, part.specs, part.index);
      });
    }
  }
  std::size_t records = into.records.size();
  for (const Part& part : all) records += part.index.records.size();
  into.records.reserve(records);
  for (Part& part : all) {
    if (!part.outcome) return std::move(part.outcome);
    std::move(part.index.records.begin(), part.index.records.end(),
              std::back_inserter(into.records));
    std::move(part.index.left_out.begin(), part.index.left_out.end(),
              std::back_inserter(into.left_out));
  }
  return Done{};
}

}  // namespace ros2wasm
