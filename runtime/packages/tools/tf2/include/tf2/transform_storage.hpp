// One transform as the buffer keeps it.
#pragma once

#include <cstdint>

#include "tf2/LinearMath/Quaternion.hpp"
#include "tf2/LinearMath/Vector3.hpp"
#include "tf2/time.hpp"

namespace tf2 {

/// A frame's number in its buffer. 0: no frame.
typedef uint32_t CompactFrameID;

class TransformStorage {
 public:
  TransformStorage() = default;
  TransformStorage(const TimePoint& stamp, const Quaternion& q, const Vector3& t,
                   CompactFrameID frame_id, CompactFrameID child_frame_id)
      : rotation_(q),
        translation_(t),
        stamp_(stamp),
        frame_id_(frame_id),
        child_frame_id_(child_frame_id) {}

  bool operator==(const TransformStorage& other) const {
    return rotation_ == other.rotation_ && translation_ == other.translation_ &&
           stamp_ == other.stamp_ && frame_id_ == other.frame_id_ &&
           child_frame_id_ == other.child_frame_id_;
  }
  bool operator!=(const TransformStorage& other) const { return !(*this == other); }

  Quaternion rotation_;
  Vector3 translation_;
  TimePoint stamp_;
  /// The parent.
  CompactFrameID frame_id_;
  CompactFrameID child_frame_id_;
};

}  // namespace tf2
