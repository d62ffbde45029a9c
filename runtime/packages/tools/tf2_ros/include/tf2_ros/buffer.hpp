// A buffer of transforms for nodes: its lookups can wait.
#pragma once

#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <unordered_map>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rclcpp/create_service.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_logging_interface.hpp"
#include "rclcpp/node_interfaces/node_services_interface.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2/buffer_core.hpp"
#include "tf2/time.hpp"
#include "tf2_msgs/srv/frame_graph.hpp"
#include "tf2_ros/async_buffer_interface.hpp"
#include "tf2_ros/buffer_interface.hpp"
#include "tf2_ros/create_timer_interface.hpp"

namespace tf2_ros {

/// Every lookup first takes in what has come meanwhile. A lookup with a timeout needs a
/// TransformListener that spins by itself.
class Buffer : public BufferInterface, public AsyncBufferInterface, public tf2::BufferCore {
 public:
  using SharedPtr = std::shared_ptr<tf2_ros::Buffer>;

  /// Empties itself when `clock` jumps back. With a node, offers the service `tf2_frames`. Throws
  /// std::invalid_argument without a clock.
  template <typename NodeT = rclcpp::Node::SharedPtr>
  Buffer(rclcpp::Clock::SharedPtr clock,
         tf2::Duration cache_time = tf2::Duration(tf2::BUFFER_CORE_DEFAULT_CACHE_TIME),
         NodeT&& node = NodeT(), const rclcpp::QoS& qos = rclcpp::ServicesQoS())
      : BufferCore(cache_time), clock_(clock) {
    watch_clock();
    if (node) {
      node_logging_interface_ = rclcpp::node_interfaces::get_node_logging_interface(node);
      frames_server_ = rclcpp::create_service<tf2_msgs::srv::FrameGraph>(
          rclcpp::node_interfaces::get_node_base_interface(node),
          rclcpp::node_interfaces::get_node_services_interface(node), "tf2_frames",
          [this](const tf2_msgs::srv::FrameGraph::Request::SharedPtr,
                 tf2_msgs::srv::FrameGraph::Response::SharedPtr response) {
            response->frame_yaml = allFramesAsYAML();
          },
          qos, nullptr);
    }
  }

  geometry_msgs::msg::TransformStamped lookupTransform(const std::string& target_frame,
                                                       const std::string& source_frame,
                                                       const tf2::TimePoint& time) const override;
  geometry_msgs::msg::TransformStamped lookupTransform(const std::string& target_frame,
                                                       const std::string& source_frame,
                                                       const tf2::TimePoint& time,
                                                       const tf2::Duration timeout) const override;
  geometry_msgs::msg::TransformStamped lookupTransform(
      const std::string& target_frame, const std::string& source_frame, const rclcpp::Time& time,
      const rclcpp::Duration timeout = rclcpp::Duration::from_nanoseconds(0)) const {
    return lookupTransform(target_frame, source_frame, fromRclcpp(time), fromRclcpp(timeout));
  }
  geometry_msgs::msg::TransformStamped lookupTransform(
      const std::string& target_frame, const tf2::TimePoint& target_time,
      const std::string& source_frame, const tf2::TimePoint& source_time,
      const std::string& fixed_frame) const override;
  geometry_msgs::msg::TransformStamped lookupTransform(const std::string& target_frame,
                                                       const tf2::TimePoint& target_time,
                                                       const std::string& source_frame,
                                                       const tf2::TimePoint& source_time,
                                                       const std::string& fixed_frame,
                                                       const tf2::Duration timeout) const override;
  geometry_msgs::msg::TransformStamped lookupTransform(
      const std::string& target_frame, const rclcpp::Time& target_time,
      const std::string& source_frame, const rclcpp::Time& source_time,
      const std::string& fixed_frame,
      const rclcpp::Duration timeout = rclcpp::Duration::from_nanoseconds(0)) const {
    return lookupTransform(target_frame, fromRclcpp(target_time), source_frame,
                           fromRclcpp(source_time), fixed_frame, fromRclcpp(timeout));
  }

  bool canTransform(const std::string& target_frame, const std::string& source_frame,
                    const tf2::TimePoint& time, std::string* error_msg = nullptr) const override;
  bool canTransform(const std::string& target_frame, const std::string& source_frame,
                    const tf2::TimePoint& target_time, const tf2::Duration timeout,
                    std::string* errstr = nullptr) const override;
  bool canTransform(const std::string& target_frame, const std::string& source_frame,
                    const rclcpp::Time& time,
                    const rclcpp::Duration timeout = rclcpp::Duration::from_nanoseconds(0),
                    std::string* errstr = nullptr) const {
    return canTransform(target_frame, source_frame, fromRclcpp(time), fromRclcpp(timeout), errstr);
  }
  bool canTransform(const std::string& target_frame, const tf2::TimePoint& target_time,
                    const std::string& source_frame, const tf2::TimePoint& source_time,
                    const std::string& fixed_frame,
                    std::string* error_msg = nullptr) const override;
  bool canTransform(const std::string& target_frame, const tf2::TimePoint& target_time,
                    const std::string& source_frame, const tf2::TimePoint& source_time,
                    const std::string& fixed_frame, const tf2::Duration timeout,
                    std::string* errstr = nullptr) const override;
  bool canTransform(const std::string& target_frame, const rclcpp::Time& target_time,
                    const std::string& source_frame, const rclcpp::Time& source_time,
                    const std::string& fixed_frame,
                    const rclcpp::Duration timeout = rclcpp::Duration::from_nanoseconds(0),
                    std::string* errstr = nullptr) const {
    return canTransform(target_frame, fromRclcpp(target_time), source_frame,
                        fromRclcpp(source_time), fixed_frame, fromRclcpp(timeout), errstr);
  }

  /// Calls back with a future that has the transform, a LookupException, or a TimeoutException.
  /// Throws CreateTimerInterfaceException when there is no timer interface.
  TransformStampedFuture waitForTransform(const std::string& target_frame,
                                          const std::string& source_frame,
                                          const tf2::TimePoint& time, const tf2::Duration& timeout,
                                          TransformReadyCallback callback) override;
  TransformStampedFuture waitForTransform(const std::string& target_frame,
                                          const std::string& source_frame, const rclcpp::Time& time,
                                          const rclcpp::Duration& timeout,
                                          TransformReadyCallback callback) {
    return waitForTransform(target_frame, source_frame, fromRclcpp(time), fromRclcpp(timeout),
                            std::move(callback));
  }
  void cancel(const TransformStampedFuture& ts_future) override;
  void setCreateTimerInterface(CreateTimerInterface::SharedPtr create_timer_interface) {
    timer_interface_ = create_timer_interface;
  }

 private:
  void watch_clock();
  void on_time_jump(const rcl_time_jump_t& jump);
  bool has_listener(std::string* errstr) const;
  /// Asks until the answer is yes or the time is over. `errstr` also gets how long it took.
  bool ask_for(const std::function<bool()>& can_transform, tf2::Duration timeout,
               std::string* errstr) const;
  /// Ends a wait: forgets it and its timer. False when it had ended.
  bool end_wait(tf2::TransformableRequestHandle request);
  rclcpp::Logger getLogger() const;

  rclcpp::Service<tf2_msgs::srv::FrameGraph>::SharedPtr frames_server_;
  rclcpp::Clock::SharedPtr clock_;
  rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr node_logging_interface_;
  CreateTimerInterface::SharedPtr timer_interface_;
  std::mutex waits_mutex_;
  std::unordered_map<tf2::TransformableRequestHandle, TimerHandle> timer_of_wait_;
  rclcpp::JumpHandler::SharedPtr jump_handler_;
};

static const char threading_error[] =
    "Do not call canTransform or lookupTransform with a timeout unless you are using another "
    "thread for populating data. Without a dedicated thread it will always timeout.  If you have "
    "a separate thread servicing tf messages, call setUsingDedicatedThread(true) on your Buffer "
    "instance.";

}  // namespace tf2_ros
