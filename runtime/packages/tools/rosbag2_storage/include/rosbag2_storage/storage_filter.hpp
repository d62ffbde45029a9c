// Which topics of a bag are read. Empty: all.
#pragma once

#include <string>
#include <vector>

namespace rosbag2_storage {

struct StorageFilter {
  std::vector<std::string> topics;
  /// Event topics of services, which `topics` says nothing of.
  std::vector<std::string> services_events;
  /// Must match whole names; the topics of the lists are read too.
  std::string regex = "";
  std::vector<std::string> exclude_topics = {};
  std::vector<std::string> exclude_service_events = {};
  std::string regex_to_exclude = "";
};

}  // namespace rosbag2_storage
