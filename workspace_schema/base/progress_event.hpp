// Progress as a value. Steps report it through a ProgressSink; cli/progress.cpp shows it as a bar,
// as lines or as JSON. A step never prints.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace ros2wasm {

/// `step` is one word of the pack's steps ("index", "solve", "fetch", "build", "emit" ...), `item`
/// what it is busy with now (a package, a file). `total` 0 means that the end is not known. `done
/// == total` ends the step.
struct ProgressEvent {
  std::string step;
  std::string item;
  std::uint64_t done = 0;
  std::uint64_t total = 0;
  std::string unit;            ///< "bytes", "packages" ...; may be empty
  std::uint64_t warnings = 0;  ///< that the compiler gave for `item` so far
};

/// May be empty: test before calling. Called on the thread that runs the step.
using ProgressSink = std::function<void(const ProgressEvent&)>;

inline void begin_step(const ProgressSink& progress, const char* step) {
  if (progress) progress({.step = step, .item = {}, .done = 0, .total = 0, .unit = {}});
}

}  // namespace ros2wasm
