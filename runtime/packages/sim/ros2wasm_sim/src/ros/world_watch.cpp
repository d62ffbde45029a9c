// See world_watch.hpp.
#include "ros/world_watch.hpp"

#include <algorithm>
#include <utility>

namespace ros2wasm_sim {
namespace {

using std::chrono_literals::operator""s;

constexpr int kLooksAtFrames = 30;    // of 2 s
constexpr int kLooksBeforeClock = 4;  // a bridge may start late

}  // namespace

WorldWatch::WorldWatch(rclcpp::Node::SharedPtr node, bool needs_bridge)
    : node_(std::move(node)), looks_at_clock_(needs_bridge) {
  timer_ = node_->create_wall_timer(2s, [this] { look(); });
}

void WorldWatch::look() {
  if (looks_at_clock_) look_at_clock();
  if (looks_ > kLooksAtFrames) return;
  // Two publishers of a transform are two publishers of the topic.
  if (!transforms_ && node_->count_publishers("/tf") > 1)
    transforms_ = node_->create_subscription<tf2_msgs::msg::TFMessage>(
        "/tf", rclcpp::QoS(100),
        [this](const tf2_msgs::msg::TFMessage& message, const rclcpp::MessageInfo& info) {
          Gid from{};
          const auto& data = info.get_rmw_message_info().publisher_gid.data;
          std::copy_n(data, std::min(from.size(), std::size(data)), from.begin());
          listen(message, from);
        });
  if (transforms_ && ++looks_ > kLooksAtFrames) transforms_.reset();
}

void WorldWatch::look_at_clock() {
  const auto waiting = node_->get_subscriptions_info_by_topic("/clock");
  if (node_->count_publishers("/clock") > 0) {
    looks_at_clock_ = false;
    return;
  }
  looks_without_clock_ = waiting.empty() ? 0 : looks_without_clock_ + 1;
  if (looks_without_clock_ < kLooksBeforeClock) return;
  looks_at_clock_ = false;
  RCLCPP_WARN(node_->get_logger(),
              "no bridge for /clock: [%s]%s with use_sim_time, so time stands still there. Add "
              "`/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock` to the arguments of parameter_bridge "
              "(package ros_gz_bridge)",
              waiting.front().node_name().c_str(),
              waiting.size() == 1
                  ? " runs"
                  : (" and " + std::to_string(waiting.size() - 1) + " more run").c_str());
}

std::string WorldWatch::name_of(const Gid& publisher) const {
  for (const auto& end : node_->get_publishers_info_by_topic("/tf"))
    if (std::equal(publisher.begin(), publisher.end(), end.endpoint_gid().begin()))
      return end.node_name();
  return "a node that has ended";
}

void WorldWatch::listen(const tf2_msgs::msg::TFMessage& message, const Gid& from) {
  for (const auto& one : message.transforms) {
    const auto [found, is_new] = frames_.try_emplace(one.child_frame_id);
    Frame& frame = found->second;
    if (is_new) {
      frame.parent = one.header.frame_id;
      frame.first = from;
    } else if (frame.first != from) {
      frame.second = from;
      frame.has_second = true;
    } else if (frame.has_second && !std::exchange(frame.is_reported, true)) {
      // The first one again, after another one: neither has replaced the other.
      RCLCPP_WARN(node_->get_logger(),
                  "two nodes publish the transform from [%s] to [%s]: [%s] and [%s]. The robot "
                  "jumps between both: let one of them not publish it (`publish_odom_tf` of a "
                  "plugin, `publish_tf` of a filter, the topic of frames of a bridge)",
                  frame.parent.c_str(), one.child_frame_id.c_str(), name_of(frame.first).c_str(),
                  name_of(frame.second).c_str());
    }
  }
}

}  // namespace ros2wasm_sim
