// Lets a message pass when it can be transformed into the frames that its reader works in.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <iterator>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "message_filters/connection.h"
#include "message_filters/message_traits.h"
#include "message_filters/simple_filter.h"
#include "rclcpp/rclcpp.hpp"
#include "tf2/buffer_core_interface.hpp"
#include "tf2/time.hpp"
#include "tf2_ros/async_buffer_interface.hpp"
#include "tf2_ros/buffer.hpp"

namespace tf2_ros {

namespace filter_failure_reasons {
enum FilterFailureReason {
  /// It was pushed out of a full queue, nobody knows why it waited.
  Unknown,
  /// It is older than all transforms that are kept.
  OutTheBack,
  EmptyFrameID,
  NoTransformFound,
  QueueFull,
  FilterFailureReasonCount,
};
}  // namespace filter_failure_reasons
using FilterFailureReason = filter_failure_reasons::FilterFailureReason;

inline std::string get_filter_failure_reason_string(FilterFailureReason reason) {
  switch (reason) {
    case filter_failure_reasons::OutTheBack:
      return "the timestamp on the message is earlier than all the data in the transform cache";
    case filter_failure_reasons::EmptyFrameID:
      return "the frame id of the message is empty";
    case filter_failure_reasons::NoTransformFound:
      return "did not find a valid transform, this usually happens at startup ...";
    case filter_failure_reasons::QueueFull:
      return "discarding message because the queue is full";
    default:
      return "unknown";
  }
}

class MessageFilterBase {
 public:
  using V_string = std::vector<std::string>;

  virtual ~MessageFilterBase() = default;
  virtual void clear() = 0;
  virtual void setTargetFrame(const std::string& target_frame) = 0;
  virtual void setTargetFrames(const V_string& target_frames) = 0;
  virtual void setTolerance(const rclcpp::Duration& tolerance) = 0;
};

template <class M, class BufferT = tf2_ros::Buffer>
class MessageFilter : public MessageFilterBase, public message_filters::SimpleFilter<M> {
  static_assert(std::is_base_of_v<tf2::BufferCoreInterface, BufferT>,
                "a buffer implements tf2::BufferCoreInterface");
  static_assert(std::is_base_of_v<tf2_ros::AsyncBufferInterface, BufferT>,
                "a buffer implements tf2_ros::AsyncBufferInterface");
  using LoggingPtr = rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr;
  using ClockPtr = rclcpp::node_interfaces::NodeClockInterface::SharedPtr;

 public:
  using MConstPtr = std::shared_ptr<const M>;
  using MEvent = message_filters::MessageEvent<const M>;

  /// If more than `queue_size` messages wait, the oldest is dropped; 0: no limit. A message waits
  /// for `buffer_timeout` at most. With a filter `f`, its output is the input.
  template <typename RepT = int64_t, typename PeriodT = std::nano>
  MessageFilter(BufferT& buffer, const std::string& target_frame, uint32_t queue_size,
                const rclcpp::Node::SharedPtr& node,
                std::chrono::duration<RepT, PeriodT> buffer_timeout =
                    std::chrono::duration<RepT, PeriodT>::max())
      : MessageFilter(buffer, target_frame, queue_size, node->get_node_logging_interface(),
                      node->get_node_clock_interface(), buffer_timeout) {}
  template <typename RepT = int64_t, typename PeriodT = std::nano>
  MessageFilter(BufferT& buffer, const std::string& target_frame, uint32_t queue_size,
                const LoggingPtr& node_logging, const ClockPtr& node_clock,
                std::chrono::duration<RepT, PeriodT> buffer_timeout =
                    std::chrono::duration<RepT, PeriodT>::max())
      : buffer_(buffer),
        queue_size_(queue_size),
        logging_(node_logging),
        clock_(node_clock),
        timeout_(std::chrono::duration_cast<tf2::Duration>(buffer_timeout)) {
    setTargetFrame(target_frame);
  }
  template <class F, typename RepT = int64_t, typename PeriodT = std::nano>
  MessageFilter(F& f, BufferT& buffer, const std::string& target_frame, uint32_t queue_size,
                const rclcpp::Node::SharedPtr& node,
                std::chrono::duration<RepT, PeriodT> buffer_timeout =
                    std::chrono::duration<RepT, PeriodT>::max())
      : MessageFilter(buffer, target_frame, queue_size, node, buffer_timeout) {
    connectInput(f);
  }
  template <class F, typename RepT = int64_t, typename PeriodT = std::nano>
  MessageFilter(F& f, BufferT& buffer, const std::string& target_frame, uint32_t queue_size,
                const LoggingPtr& node_logging, const ClockPtr& node_clock,
                std::chrono::duration<RepT, PeriodT> buffer_timeout =
                    std::chrono::duration<RepT, PeriodT>::max())
      : MessageFilter(buffer, target_frame, queue_size, node_logging, node_clock, buffer_timeout) {
    connectInput(f);
  }
  ~MessageFilter() override {
    input_.disconnect();
    clear();
  }

  template <class F>
  void connectInput(F& f) {
    input_.disconnect();
    input_ = f.registerCallback([this](const MEvent& event) { add(event); });
  }

  void setTargetFrame(const std::string& target_frame) override {
    setTargetFrames(V_string{target_frame});
  }
  void setTargetFrames(const V_string& target_frames) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    frames_.clear();
    std::transform(target_frames.begin(), target_frames.end(), std::back_inserter(frames_),
                   without_slash);
  }
  std::string getTargetFramesString() {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::string text;
    for (const std::string& frame : frames_) {
      text += frame + " ";
    }
    return text;
  }
  /// A message must also be transformable so much after its time.
  void setTolerance(const rclcpp::Duration& tolerance) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    tolerance_ = tf2::Duration(tolerance.nanoseconds());
  }
  virtual void setQueueSize(uint32_t new_queue_size) { queue_size_ = new_queue_size; }
  virtual uint32_t getQueueSize() { return queue_size_; }

  /// Forgets what waits.
  void clear() override {
    std::list<Waiting> gone;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      gone.swap(waiting_);
    }
    for (const Waiting& each : gone) {
      cancel(each);
    }
  }

  void add(const MConstPtr& message) { add(MEvent(message, clock_->get_clock()->now())); }
  void add(const MEvent& evt) {
    const std::string frame = frame_of(evt);
    if (frame.empty()) {
      drop(evt, filter_failure_reasons::EmptyFrameID);
      return;
    }
    std::vector<Wish> wishes;
    uint64_t id = 0;
    std::list<Waiting> pushed_out;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      wishes = wishes_for(evt);
      if (wishes.empty()) {
        return;
      }
      if (queue_size_ != 0 && waiting_.size() + 1 > queue_size_) {
        pushed_out.splice(pushed_out.begin(), waiting_, waiting_.begin());
      }
      id = ++last_id_;
      waiting_.push_back(Waiting{id, evt, wishes.size(), false, {}});
    }
    for (const Waiting& each : pushed_out) {
      cancel(each);
      drop(each.event, filter_failure_reasons::QueueFull);
    }
    for (const Wish& wish : wishes) {
      // Calls back at once when it is known whether the transform comes.
      const TransformStampedFuture future = buffer_.waitForTransform(
          wish.frame, frame, wish.time, timeout_,
          [this, id](const TransformStampedFuture& decided) { on_decided(id, decided); });
      std::unique_lock<std::mutex> lock(mutex_);
      const auto found = find(id);
      if (found != waiting_.end()) {
        found->futures.push_back(future);
      } else {
        lock.unlock();
        buffer_.cancel(future);  // decided, or forgotten meanwhile
      }
    }
  }

 private:
  struct Wish {
    std::string frame;
    tf2::TimePoint time;
  };
  struct Waiting {
    uint64_t id;
    MEvent event;
    /// How many transforms are not decided yet.
    size_t undecided;
    bool failed;
    std::vector<TransformStampedFuture> futures;
  };

  static std::string without_slash(const std::string& frame) {
    return frame.substr(frame.rfind('/', 0) == 0 ? 1 : 0);
  }
  static std::string frame_of(const MEvent& event) {
    return without_slash(
        message_filters::message_traits::FrameId<M>::value(*event.getConstMessage()));
  }
  static rclcpp::Time stamp_of(const MEvent& event) {
    return message_filters::message_traits::TimeStamp<M>::value(*event.getConstMessage());
  }

  [[nodiscard]] std::vector<Wish> wishes_for(const MEvent& event) const {
    const tf2::TimePoint time = fromRclcpp(stamp_of(event));
    std::vector<Wish> wishes;
    for (const std::string& frame : frames_) {
      wishes.push_back({frame, time});
      if (tolerance_ != tf2::Duration::zero()) {
        wishes.push_back({frame, time + tolerance_});
      }
    }
    return wishes;
  }

  typename std::list<Waiting>::iterator find(uint64_t id) {
    return std::find_if(waiting_.begin(), waiting_.end(),
                        [id](const Waiting& each) { return each.id == id; });
  }

  void cancel(const Waiting& each) {
    for (const TransformStampedFuture& future : each.futures) {
      buffer_.cancel(future);
    }
  }

  void on_decided(uint64_t id, const TransformStampedFuture& decided) {
    std::list<Waiting> done;
    std::vector<Wish> wishes;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      const auto found = find(id);
      if (found == waiting_.end()) {
        return;
      }
      found->failed = found->failed || has_failed(decided);
      if (--found->undecided > 0) {
        return;
      }
      done.splice(done.begin(), waiting_, found);
      wishes = wishes_for(done.front().event);
    }
    const MEvent& event = done.front().event;
    if (done.front().failed) {
      drop(event, filter_failure_reasons::OutTheBack);
      return;
    }
    const std::string frame = frame_of(event);
    // The transforms that came first may be too old by now.
    const bool still = std::all_of(wishes.begin(), wishes.end(), [&](const Wish& wish) {
      return buffer_.canTransform(wish.frame, frame, wish.time, nullptr);
    });
    if (still) {
      this->signalMessage(event);
    } else {
      drop(event, filter_failure_reasons::Unknown);
    }
  }

  static bool has_failed(const TransformStampedFuture& decided) {
    try {
      decided.get();
      return false;
    } catch (const std::exception&) {
      return true;
    }
  }

  void drop(const MEvent& event, FilterFailureReason reason) const {
    RCLCPP_INFO(logging_->get_logger(),
                "Message Filter dropping message: frame '%s' at time %.3f for reason '%s'",
                frame_of(event).c_str(), stamp_of(event).seconds(),
                get_filter_failure_reason_string(reason).c_str());
  }

  BufferT& buffer_;
  std::atomic<uint32_t> queue_size_;
  const LoggingPtr logging_;
  const ClockPtr clock_;
  const tf2::Duration timeout_;
  std::mutex mutex_;
  V_string frames_;
  tf2::Duration tolerance_ = tf2::Duration::zero();
  uint64_t last_id_ = 0;
  /// The oldest first.
  std::list<Waiting> waiting_;
  message_filters::Connection input_;
};

}  // namespace tf2_ros
