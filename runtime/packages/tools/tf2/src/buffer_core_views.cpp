// The content of a buffer as text and as lists, for tools. No streams: they add 30 kB (brotli) to a
// program that has none.
#include <algorithm>
#include <cstdio>
#include <string>

#include "tf2/buffer_core.hpp"
#include "tf2/time_cache.hpp"

namespace tf2 {
namespace {

double rate_of(TimeCacheInterface& cache) {
  const Duration length = cache.getLatestTimestamp() - cache.getOldestTimestamp();
  const Duration counted = std::max<Duration>(length, std::chrono::microseconds(100));
  return cache.getListLength() * 1e9 / static_cast<double>(counted.count());
}

/// With three digits behind the point.
std::string fixed(double value) {
  char text[340];  // the greatest double has 309 digits
  std::snprintf(text, sizeof text, "%.3f", value);
  return text;
}

std::string recorded_at(TimePoint time) {
  return time == TimePointZero
             ? ""
             : "\"Recorded at time: " + displayTimePoint(time) + "\"[ shape=plaintext ] ;\n ";
}

constexpr char kLegend[] =
    "edge [style=invis];\n subgraph cluster_legend { style=bold; color=black; label "
    "=\"view_frames Result\";\n";

}  // namespace

template <typename VisitT>
void BufferCore::for_each_told_frame(VisitT&& visit) const {
  for (size_t i = 1; i < frames_.size(); ++i) {
    TransformStorage latest;
    if (frames_[i].cache && frames_[i].cache->getData(TimePointZero, latest)) {
      visit(frames_[i], frames_[latest.frame_id_].name);
    }
  }
}

std::string BufferCore::frames_as_string() const {
  std::string text;
  for_each_told_frame([&](const Frame& frame, const std::string& parent) {
    text += "Frame " + frame.name + " exists with parent " + parent + ".\n";
  });
  return text;
}

std::string BufferCore::allFramesAsString() const {
  const std::lock_guard<std::mutex> lock(frame_mutex_);
  return frames_as_string();
}

std::string BufferCore::allFramesAsYAML(TimePoint current_time) const {
  const std::lock_guard<std::mutex> lock(frame_mutex_);
  std::string text;
  if (frames_.size() == 1) {
    text += "[]";
  }
  for_each_told_frame([&](const Frame& frame, const std::string& parent) {
    const TimePoint latest = frame.cache->getLatestTimestamp();
    const TimePoint oldest = frame.cache->getOldestTimestamp();
    text += frame.name + ": \n  parent: '" + parent + "'\n  broadcaster: '" + frame.authority +
            "'\n  rate: " + fixed(rate_of(*frame.cache)) +
            "\n  most_recent_transform: " + displayTimePoint(latest) +
            "\n  oldest_transform: " + displayTimePoint(oldest) + "\n";
    if (current_time != TimePointZero) {
      text += "  transform_delay: " + fixed(durationToSec(current_time - latest)) + "\n";
    }
    text += "  buffer_length: " + fixed(durationToSec(latest - oldest)) + "\n";
  });
  return text;
}

std::string BufferCore::allFramesAsYAML() const {
  return allFramesAsYAML(TimePointZero);
}

std::string BufferCore::_allFramesAsDot(TimePoint current_time) const {
  const std::lock_guard<std::mutex> lock(frame_mutex_);
  std::string text = "digraph G {\n";
  if (frames_.size() == 1) {
    text += "\"no tf data recieved\"";
  }
  for_each_told_frame([&](const Frame& frame, const std::string& parent) {
    const TimePoint latest = frame.cache->getLatestTimestamp();
    text += '"' + parent + "\" -> \"" + frame.name + "\"[label=\"Broadcaster: " + frame.authority +
            "\\nAverage rate: " + fixed(rate_of(*frame.cache)) +
            " Hz\\nMost recent transform: " + displayTimePoint(latest) + " ";
    if (current_time != TimePointZero) {
      text += "( " + fixed(durationToSec(current_time - latest)) + " sec old)";
    }
    text +=
        "\\nBuffer length: " + fixed(durationToSec(latest - frame.cache->getOldestTimestamp())) +
        " sec\\n\"];\n";
  });
  // The legend hangs on the roots.
  for (size_t i = 1; i < frames_.size(); ++i) {
    TransformStorage latest;
    const auto& cache = frames_[i].cache;
    const bool empty = cache && !cache->getData(TimePointZero, latest);
    if (empty || (!cache && current_time != TimePointZero)) {
      text += kLegend + recorded_at(current_time) + "}->\"" + frames_[i].name + "\";\n";
    }
  }
  text += "}";
  return text;
}

std::string BufferCore::_allFramesAsDot() const {
  return _allFramesAsDot(TimePointZero);
}

std::vector<std::string> BufferCore::getAllFrameNames() const {
  std::vector<std::string> names;
  _getFrameStrings(names);
  return names;
}

void BufferCore::_getFrameStrings(std::vector<std::string>& ids) const {
  const std::lock_guard<std::mutex> lock(frame_mutex_);
  ids.clear();
  for (size_t i = 1; i < frames_.size(); ++i) {
    ids.push_back(frames_[i].name);
  }
}

bool BufferCore::_frameExists(const std::string& frame_id_str) const {
  const std::lock_guard<std::mutex> lock(frame_mutex_);
  return numbers_.count(frame_id_str) != 0;
}

bool BufferCore::_getParent(const std::string& frame_id, TimePoint time,
                            std::string& parent) const {
  const std::lock_guard<std::mutex> lock(frame_mutex_);
  const auto& cache = frames_[number_of(frame_id)].cache;
  const CompactFrameID number = cache ? cache->getParent(time) : 0;
  if (number == 0) {
    return false;
  }
  parent = name_of(number);
  return true;
}

CompactFrameID BufferCore::_lookupFrameNumber(const std::string& frameid_str) const {
  const std::lock_guard<std::mutex> lock(frame_mutex_);
  return number_of(frameid_str);
}

CompactFrameID BufferCore::_lookupOrInsertFrameNumber(const std::string& frameid_str) {
  const std::lock_guard<std::mutex> lock(frame_mutex_);
  return number_or_new(frameid_str);
}

TF2Error BufferCore::_getLatestCommonTime(CompactFrameID target_frame, CompactFrameID source_frame,
                                          TimePoint& time, std::string* error_string) const {
  const std::lock_guard<std::mutex> lock(frame_mutex_);
  return latest_common_time(target_frame, source_frame, time, error_string);
}

CompactFrameID BufferCore::_validateFrameId(const char* function_name_arg,
                                            const std::string& frame_id) const {
  const std::lock_guard<std::mutex> lock(frame_mutex_);
  return checked_number(function_name_arg, frame_id);
}

std::vector<CompactFrameID> BufferCore::chain(CompactFrameID target, CompactFrameID source,
                                              TimePoint time) const {
  const Path path = checked_path(target, source, time);
  std::vector<CompactFrameID> frames;
  for (const TransformStorage& step : path.from_source) {
    frames.push_back(step.child_frame_id_);
  }
  frames.push_back(path.from_source.empty() ? source : path.from_source.back().frame_id_);
  for (auto step = path.from_target.rbegin(); step != path.from_target.rend(); ++step) {
    frames.push_back(step->child_frame_id_);
  }
  return frames;
}

void BufferCore::_chainAsVector(const std::string& target_frame, TimePoint target_time,
                                const std::string& source_frame, TimePoint source_time,
                                const std::string& fixed_frame,
                                std::vector<std::string>& output) const {
  const std::lock_guard<std::mutex> lock(frame_mutex_);
  const CompactFrameID fixed = number_of(fixed_frame);
  std::vector<CompactFrameID> frames = chain(fixed, number_of(source_frame), source_time);
  const std::vector<CompactFrameID> rest = chain(number_of(target_frame), fixed, target_time);
  frames.insert(frames.end(), rest.begin() + 1, rest.end());
  output.clear();
  for (const CompactFrameID frame : frames) {
    output.push_back(name_of(frame));
  }
}

}  // namespace tf2
