// The tree of frames over time: takes transforms in, answers where one frame stands in another.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "geometry_msgs/msg/velocity_stamped.hpp"
#include "tf2/LinearMath/Transform.hpp"
#include "tf2/buffer_core_interface.hpp"
#include "tf2/exceptions.hpp"
#include "tf2/transform_storage.hpp"

namespace tf2 {

typedef std::pair<TimePoint, CompactFrameID> P_TimeAndFrameID;
typedef uint64_t TransformableRequestHandle;

class TimeCacheInterface;
using TimeCacheInterfacePtr = std::shared_ptr<TimeCacheInterface>;

enum TransformableResult {
  TransformAvailable,
  TransformFailure,
};

static constexpr Duration BUFFER_CORE_DEFAULT_CACHE_TIME = std::chrono::seconds(10);

/// All lookups throw LookupException for a frame that is not there, ConnectivityException for
/// frames of different trees, ExtrapolationException for a time without data, and
/// InvalidArgumentException for a name that is empty or begins with a slash. May be used from
/// several threads.
class BufferCore : public BufferCoreInterface {
 public:
  /// A path that is longer is taken as a loop.
  static const uint32_t MAX_GRAPH_DEPTH = 1000UL;

  explicit BufferCore(Duration cache_time = BUFFER_CORE_DEFAULT_CACHE_TIME);
  ~BufferCore() override;

  void clear() override;
  /// False, with a log line, for a transform that cannot be taken. `authority` says who sent it.
  bool setTransform(const geometry_msgs::msg::TransformStamped& transform,
                    const std::string& authority, bool is_static = false);

  /// Where `source_frame` stands in `target_frame`. TimePointZero: the latest common time.
  geometry_msgs::msg::TransformStamped lookupTransform(const std::string& target_frame,
                                                       const std::string& source_frame,
                                                       const TimePoint& time) const override;
  /// Across time, by way of a frame that does not move.
  geometry_msgs::msg::TransformStamped lookupTransform(
      const std::string& target_frame, const TimePoint& target_time,
      const std::string& source_frame, const TimePoint& source_time,
      const std::string& fixed_frame) const override;
  geometry_msgs::msg::VelocityStamped lookupVelocity(const std::string& tracking_frame,
                                                     const std::string& observation_frame,
                                                     const TimePoint& time,
                                                     const Duration& averaging_interval) const;
  geometry_msgs::msg::VelocityStamped lookupVelocity(const std::string& tracking_frame,
                                                     const std::string& observation_frame,
                                                     const std::string& reference_frame,
                                                     const Vector3& reference_point,
                                                     const std::string& reference_point_frame,
                                                     const TimePoint& time,
                                                     const Duration& duration) const;
  bool canTransform(const std::string& target_frame, const std::string& source_frame,
                    const TimePoint& time, std::string* error_msg = nullptr) const override;
  bool canTransform(const std::string& target_frame, const TimePoint& target_time,
                    const std::string& source_frame, const TimePoint& source_time,
                    const std::string& fixed_frame,
                    std::string* error_msg = nullptr) const override;

  std::vector<std::string> getAllFrameNames() const override;
  std::string allFramesAsYAML(TimePoint current_time) const;
  std::string allFramesAsYAML() const;
  std::string allFramesAsString() const;

  using TransformableCallback = std::function<void(
      TransformableRequestHandle request_handle, const std::string& target_frame,
      const std::string& source_frame, TimePoint time, TransformableResult result)>;
  /// Calls back once, when the transform can be had or never will. 0: it can be had now; all ones:
  /// it never will.
  TransformableRequestHandle addTransformableRequest(const TransformableCallback& cb,
                                                     const std::string& target_frame,
                                                     const std::string& source_frame,
                                                     TimePoint time);
  void cancelTransformableRequest(TransformableRequestHandle handle);

  void setUsingDedicatedThread(bool value) { using_dedicated_thread_ = value; }
  bool isUsingDedicatedThread() const { return using_dedicated_thread_; }

  bool _frameExists(const std::string& frame_id_str) const;
  bool _getParent(const std::string& frame_id, TimePoint time, std::string& parent) const;
  void _getFrameStrings(std::vector<std::string>& ids) const;
  CompactFrameID _lookupFrameNumber(const std::string& frameid_str) const;
  CompactFrameID _lookupOrInsertFrameNumber(const std::string& frameid_str);
  TF2Error _getLatestCommonTime(CompactFrameID target_frame, CompactFrameID source_frame,
                                TimePoint& time, std::string* error_string) const;
  CompactFrameID _validateFrameId(const char* function_name_arg, const std::string& frame_id) const;
  Duration getCacheLength() { return cache_time_; }
  std::string _allFramesAsDot(TimePoint current_time) const;
  std::string _allFramesAsDot() const;
  void _chainAsVector(const std::string& target_frame, TimePoint target_time,
                      const std::string& source_frame, TimePoint source_time,
                      const std::string& fixed_frame, std::vector<std::string>& output) const;

 private:
  struct Frame {
    std::string name;
    std::string authority = "no recorded authority";
    // None: nothing was told of this frame but that it is a parent.
    TimeCacheInterfacePtr cache;
  };
  struct Request {
    TransformableRequestHandle handle;
    TransformableCallback callback;
    std::string target;
    std::string source;
    TimePoint time;
  };
  // The way between two frames up to the first that both have above them.
  struct Path {
    std::vector<TransformStorage> from_source;
    std::vector<TransformStorage> from_target;
    TimePoint time;
  };
  struct Found {
    Transform transform;
    TimePoint time;
  };
  struct RateAndAge;

  // These expect that the caller holds frame_mutex_.
  CompactFrameID number_of(const std::string& name) const;
  CompactFrameID number_or_new(const std::string& name);
  CompactFrameID checked_number(const char* argument, const std::string& name) const;
  CompactFrameID known_number(const char* argument, const std::string& name,
                              std::string* error) const;
  const std::string& name_of(CompactFrameID frame) const;
  TF2Error find_path(CompactFrameID target, CompactFrameID source, TimePoint time, Path& path,
                     std::string* error) const;
  TF2Error latest_common_time(CompactFrameID target, CompactFrameID source, TimePoint& time,
                              std::string* error) const;
  TF2Error loop_error(std::string* error) const;
  TF2Error unconnected(CompactFrameID target, CompactFrameID source, std::string* error) const;
  bool can_transform(CompactFrameID target, CompactFrameID source, TimePoint time,
                     std::string* error) const;
  Path checked_path(CompactFrameID target, CompactFrameID source, TimePoint time) const;
  std::vector<CompactFrameID> chain(CompactFrameID target, CompactFrameID source,
                                    TimePoint time) const;
  std::string frames_as_string() const;
  template <typename VisitT>
  void for_each_told_frame(VisitT&& visit) const;

  Found find(const std::string& target, const std::string& source, TimePoint time) const;
  // Whether it can be said by now what becomes of a request, and then what.
  bool is_decided(const Request& request, TransformableResult& result) const;
  void answer_requests();

  const Duration cache_time_;
  bool using_dedicated_thread_ = false;
  mutable std::mutex frame_mutex_;
  // The first one stands for no frame.
  std::vector<Frame> frames_;
  std::unordered_map<std::string, CompactFrameID> numbers_;
  std::mutex requests_mutex_;
  std::vector<Request> requests_;
  TransformableRequestHandle last_request_ = 0;
};

}  // namespace tf2
