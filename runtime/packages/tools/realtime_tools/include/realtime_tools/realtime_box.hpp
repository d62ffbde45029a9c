// The older names of RealtimeThreadSafeBox.
#pragma once

#include "realtime_tools/realtime_thread_safe_box.hpp"

namespace realtime_tools {

template <class T, typename mutex_type = std::mutex>
using RealtimeBoxBase = RealtimeThreadSafeBox<T, mutex_type>;
template <typename T>
using RealtimeBoxStandard = RealtimeBoxBase<T, std::mutex>;
template <typename T>
using RealtimeBoxRecursive = RealtimeBoxBase<T, std::recursive_mutex>;
template <typename T>
using RealtimeBox = RealtimeBoxStandard<T>;
template <typename T, typename mutex_type = std::mutex>
using RealtimeBoxBestEffort = RealtimeBoxBase<T, mutex_type>;

}  // namespace realtime_tools
