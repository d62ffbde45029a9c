// See tool_base_node.hpp.
#include "tool_base_node.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

namespace topic_tools {
namespace {

constexpr std::chrono::milliseconds kDiscoveryPeriod{100};
constexpr size_t kDepth = 10;

}  // namespace

ToolBaseNode::ToolBaseNode(const std::string& name, const rclcpp::NodeOptions& options)
    : rclcpp::Node(name, options) {}

void ToolBaseNode::start() {
  timer_ = create_wall_timer(kDiscoveryPeriod, [this] { look(); });
  look();
}

void ToolBaseNode::look() {
  const std::optional<Source> source = find_source();
  if (!source) {
    disconnect();
    return;
  }
  const bool is_same = source_ && source_->type == source->type && source_->qos == source->qos;
  if (!is_same) disconnect();
  source_ = source;
  if (publisher_ && publisher_->get_topic_name() != full_name(output_topic_)) publisher_.reset();
  if (!publisher_) publisher_ = create_generic_publisher(output_topic_, source->type, source->qos);
  if (subscription_ && subscription_->get_topic_name() != full_name(input_topic_)) {
    subscription_.reset();
  }
  if (lazy_ && publisher_->get_subscription_count() == 0) {
    subscription_.reset();
  } else if (!subscription_) {
    subscription_ = create_generic_subscription(
        input_topic_, source->type, source->qos,
        [this](std::shared_ptr<rclcpp::SerializedMessage> message) { process_message(message); });
  }
}

void ToolBaseNode::disconnect() {
  source_.reset();
  publisher_.reset();
  subscription_.reset();
}

void ToolBaseNode::send(const rclcpp::SerializedMessage& message) {
  if (publisher_) publisher_->publish(message);
}

std::string ToolBaseNode::full_name(const std::string& topic) const {
  return const_cast<ToolBaseNode*>(this)->get_node_topics_interface()->resolve_topic_name(topic);
}

std::optional<ToolBaseNode::Source> ToolBaseNode::find_source() {
  if (input_topic_.empty() || output_topic_.empty()) return {};
  const auto publishers = get_publishers_info_by_topic(input_topic_);
  if (publishers.empty()) return {};
  const size_t count = publishers.size();
  size_t reliable = 0;
  size_t transient_local = 0;
  rclcpp::Duration deadline(0, 0);
  rclcpp::Duration lifespan(0, 0);
  for (const rclcpp::TopicEndpointInfo& publisher : publishers) {
    const rclcpp::QoS& qos = publisher.qos_profile();
    reliable += qos.reliability() == rclcpp::ReliabilityPolicy::Reliable;
    transient_local += qos.durability() == rclcpp::DurabilityPolicy::TransientLocal;
    deadline = std::max(deadline, qos.deadline());
    lifespan = std::max(lifespan, qos.lifespan());
  }
  rclcpp::QoS qos(kDepth);
  qos.reliability(publishers[0].qos_profile().reliability());
  qos.durability(publishers[0].qos_profile().durability());
  qos.liveliness(rclcpp::LivelinessPolicy::Automatic);
  // A policy that only some publishers offer would keep it from the others.
  if (reliable > 0 && reliable < count) qos.best_effort();
  if (transient_local > 0 && transient_local < count) qos.durability_volatile();
  qos.deadline(deadline).lifespan(lifespan);
  const bool is_new = !source_ || source_->qos != qos;
  if (is_new && reliable > 0 && reliable < count) {
    RCLCPP_WARN(get_logger(),
                "Some, but not all, publishers on topic %s offer 'reliable' reliability. Falling "
                "back to 'best effort' reliability in orderto connect to all publishers.",
                input_topic_.c_str());
  }
  if (is_new && transient_local > 0 && transient_local < count) {
    RCLCPP_WARN(get_logger(),
                "Some, but not all, publishers on topic %s offer 'transient local' durability. "
                "Falling back to 'volatile' durability in orderto connect to all publishers.",
                input_topic_.c_str());
  }
  return Source{publishers[0].topic_type(), qos};
}

}  // namespace topic_tools
