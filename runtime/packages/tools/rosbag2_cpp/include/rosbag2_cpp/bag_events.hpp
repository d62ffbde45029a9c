// Callbacks for a bag of several files, called when one of its files is closed.
#pragma once

#include <functional>
#include <string>

namespace rosbag2_cpp {
namespace bag_events {

enum class BagEvent { WRITE_SPLIT, READ_SPLIT };

struct BagSplitInfo {
  std::string closed_file;
  /// Empty: the bag is closed.
  std::string opened_file;
};

using BagSplitCallbackType = std::function<void(BagSplitInfo&)>;

struct WriterEventCallbacks {
  BagSplitCallbackType write_split_callback;
};

struct ReaderEventCallbacks {
  BagSplitCallbackType read_split_callback;
};

}  // namespace bag_events
}  // namespace rosbag2_cpp
