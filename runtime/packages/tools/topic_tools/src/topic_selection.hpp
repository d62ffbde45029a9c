// The topics of a mux or demux, one of which is selected. Pure.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace topic_tools {

/// Selects no topic.
constexpr const char* kNoTopic = "__none";

class TopicSelection {
 public:
  /// The full name of a topic, with namespace and remappings: names that differ may be one topic.
  using Resolve = std::function<std::string(const std::string&)>;
  enum class Added { kYes, kReserved, kKnown };
  enum class Deleted { kYes, kSelected, kUnknown };

  /// With an empty `initial` the first topic is selected.
  TopicSelection(std::vector<std::string> topics, const std::string& initial, Resolve resolve)
      : topics_(std::move(topics)), selected_(initial), resolve_(std::move(resolve)) {
    if (selected_.empty()) selected_ = topics_.empty() ? kNoTopic : topics_.front();
  }

  const std::vector<std::string>& topics() const { return topics_; }
  const std::string& selected() const { return selected_; }
  bool has_selected() const { return selected_ != kNoTopic; }

  Added add(const std::string& topic) {
    if (topic == kNoTopic) return Added::kReserved;
    if (std::find(topics_.begin(), topics_.end(), topic) != topics_.end()) return Added::kKnown;
    topics_.push_back(topic);
    return Added::kYes;
  }

  Deleted erase(const std::string& topic) {
    const auto found = find(topic);
    if (found == topics_.end()) return Deleted::kUnknown;
    if (has_selected() && resolve_(selected_) == resolve_(topic)) return Deleted::kSelected;
    topics_.erase(found);
    return Deleted::kYes;
  }

  /// False for a topic that it does not have.
  bool select(const std::string& topic) {
    if (topic != kNoTopic && find(topic) == topics_.end()) return false;
    selected_ = topic;
    return true;
  }

  /// The selected topic when it is one of the topics, else an empty text.
  std::string selected_of_topics() {
    return has_selected() && find(selected_) != topics_.end() ? selected_ : std::string();
  }

 private:
  std::vector<std::string>::iterator find(const std::string& topic) {
    const std::string full = resolve_(topic);
    return std::find_if(topics_.begin(), topics_.end(),
                        [&](const std::string& one) { return resolve_(one) == full; });
  }

  std::vector<std::string> topics_;
  std::string selected_;
  Resolve resolve_;
};

}  // namespace topic_tools
