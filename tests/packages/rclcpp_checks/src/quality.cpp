// Quality of service: what fits what, best available and system defaults, and the events of both
// sides.

// Compatibility, works: event callbacks of rclcpp, `best_available`, system defaults,
// `qos_check_compatible` and the warnings of endpoints that do not fit, in the words of ROS 2; a
// node without work is not woken

#include <set>

#include "checks.hpp"
#include "rcl_interfaces/msg/log.hpp"
#include "std_msgs/msg/string.hpp"

using std_msgs::msg::String;
using namespace std::chrono_literals;

namespace {

// Counts how often an executor looks at it.
class Onlooker : public rclcpp::Waitable {
 public:
  void add_to_wait_set(rcl_wait_set_t&) override {}
  bool is_ready(const rcl_wait_set_t&) override {
    ++looks;
    return false;
  }
  std::shared_ptr<void> take_data() override { return nullptr; }
  void execute(const std::shared_ptr<void>&) override {}
  int looks = 0;
};

struct Seen {
  int32_t offered_deadlines = 0;
  int32_t requested_deadlines = 0;
  int32_t lost = 0;
  int32_t alive = 0;
  int32_t not_alive = 0;
  rmw_qos_policy_kind_t offered_policy = RMW_QOS_POLICY_INVALID;
  rmw_qos_policy_kind_t requested_policy = RMW_QOS_POLICY_INVALID;
  size_t matched = 0;
};

void check_profiles(Checks& checks, const rclcpp::Node::SharedPtr& node) {
  const rclcpp::QoS best = rclcpp::BestAvailableQoS();
  const auto ignore = [](const String&) {};
  auto first = node->create_subscription<String>("best", best, ignore);
  CHECK(first->get_actual_qos().reliability() == rclcpp::ReliabilityPolicy::Reliable);
  CHECK(first->get_actual_qos().durability() == rclcpp::DurabilityPolicy::TransientLocal);
  auto offer = rclcpp::QoS(5).best_effort().deadline(3s);
  auto publisher = node->create_publisher<String>("best_lower", offer);
  auto lower = node->create_subscription<String>("best_lower", best, ignore);
  CHECK(lower->get_actual_qos().reliability() == rclcpp::ReliabilityPolicy::BestEffort);
  CHECK(lower->get_actual_qos().durability() == rclcpp::DurabilityPolicy::Volatile);
  CHECK(lower->get_actual_qos().deadline() == rclcpp::Duration(3s));
  CHECK(lower->get_publisher_count() == 1);
  auto demanding =
      node->create_subscription<String>("best_offer",
                                        rclcpp::QoS(5).transient_local().deadline(2s).liveliness(
                                            rclcpp::LivelinessPolicy::ManualByTopic),
                                        ignore);
  auto meeting = node->create_publisher<String>("best_offer", best);
  CHECK(meeting->get_actual_qos().liveliness() == rclcpp::LivelinessPolicy::ManualByTopic);
  CHECK(meeting->get_actual_qos().deadline() == rclcpp::Duration(2s));
  CHECK(meeting->get_subscription_count() == 1);
  auto plain = node->create_publisher<String>("plain", rclcpp::SystemDefaultsQoS());
  CHECK(plain->get_actual_qos().reliability() == rclcpp::ReliabilityPolicy::Reliable);
  CHECK(plain->get_actual_qos().depth() == 1);

  const auto error = rclcpp::qos_check_compatible(rclcpp::QoS(1).best_effort(), rclcpp::QoS(1));
  CHECK(error.compatibility == rclcpp::QoSCompatibility::Error);
  CHECK(error.reason == "ERROR: Best effort publisher and reliable subscription;");
  const auto warning = rclcpp::qos_check_compatible(rclcpp::SystemDefaultsQoS(), rclcpp::QoS(1));
  CHECK(warning.compatibility == rclcpp::QoSCompatibility::Warning);
  CHECK(warning.reason ==
        "WARNING: Reliable subscription, but publisher is system_default;"
        "WARNING: Publisher liveliness is system_default and subscription liveliness is "
        "system_default;");
}

// The warnings that both sides log by themselves, word for word as people look for them.
void check_warnings(Checks& checks, const rclcpp::Node::SharedPtr& node) {
  std::set<std::string> said;
  auto rosout = node->create_subscription<rcl_interfaces::msg::Log>(
      "/rosout", rclcpp::RosoutQoS(),
      [&said](const rcl_interfaces::msg::Log& one) { said.insert(one.msg); });
  auto publisher = node->create_publisher<String>("strict", rclcpp::QoS(1).best_effort());
  auto subscription = node->create_subscription<String>("strict", 1, [](const String&) {});
  const std::string offered =
      "New subscription discovered on topic '/strict', requesting incompatible QoS. No messages "
      "will be sent to it. Last incompatible policy: RELIABILITY_QOS_POLICY";
  const std::string requested =
      "New publisher discovered on topic '/strict', offering incompatible QoS. No messages will be "
      "received from it. Last incompatible policy: RELIABILITY_QOS_POLICY";
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  while (said.count(offered) + said.count(requested) < 2) {
    executor.spin_once();
  }
  CHECK(publisher->get_subscription_count() == 0);
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("quality");
  auto node = std::make_shared<rclcpp::Node>("quality_node");
  check_profiles(checks, node);
  check_warnings(checks, node);

  Seen seen;
  const auto timely = rclcpp::QoS(1)
                          .deadline(20ms)
                          .liveliness(rclcpp::LivelinessPolicy::ManualByTopic)
                          .liveliness_lease_duration(30ms);
  rclcpp::PublisherOptions offers;
  offers.event_callbacks.deadline_callback = [&](rclcpp::QOSDeadlineOfferedInfo& info) {
    seen.offered_deadlines += info.total_count_change;
  };
  offers.event_callbacks.liveliness_callback = [&](rclcpp::QOSLivelinessLostInfo& info) {
    seen.lost = info.total_count;
  };
  rclcpp::SubscriptionOptions asks;
  asks.event_callbacks.deadline_callback = [&](rclcpp::QOSDeadlineRequestedInfo& info) {
    seen.requested_deadlines += info.total_count_change;
  };
  asks.event_callbacks.liveliness_callback = [&](rclcpp::QOSLivelinessChangedInfo& info) {
    seen.alive = info.alive_count;
    seen.not_alive = info.not_alive_count;
  };
  asks.event_callbacks.matched_callback = [&](rclcpp::MatchedInfo& info) {
    seen.matched = info.total_count;
  };
  auto subscription = node->create_subscription<String>(
      "timely", timely, [](const String&) {}, asks);
  auto publisher = node->create_publisher<String>("timely", timely, offers);
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  publisher->publish(String());
  // Nothing but time ends these waits.
  while (seen.offered_deadlines < 2 || seen.requested_deadlines < 2 || seen.not_alive == 0) {
    executor.spin_once();
  }
  CHECK(seen.matched == 1);
  CHECK(seen.alive == 0);
  while (seen.lost < 1) {
    executor.spin_once();
  }
  CHECK(publisher->assert_liveliness());
  while (seen.lost < 2) {
    executor.spin_once();
  }
  publisher.reset();
  subscription.reset();

  rclcpp::PublisherOptions modest;
  modest.event_callbacks.incompatible_qos_callback =
      [&](rclcpp::QOSOfferedIncompatibleQoSInfo& info) {
        seen.offered_policy = info.last_policy_kind;
      };
  rclcpp::SubscriptionOptions strict;
  strict.event_callbacks.incompatible_qos_callback =
      [&](rclcpp::QOSRequestedIncompatibleQoSInfo& info) {
        seen.requested_policy = info.last_policy_kind;
      };
  auto volatile_publisher = node->create_publisher<String>("unfit", 1, modest);
  auto latched = node->create_subscription<String>(
      "unfit", rclcpp::QoS(1).transient_local(), [](const String&) {}, strict);
  executor.spin_all(2s);
  CHECK(seen.offered_policy == RMW_QOS_POLICY_DURABILITY);
  CHECK(seen.requested_policy == RMW_QOS_POLICY_DURABILITY);

  // Who has nothing to do is not woken: once the other nodes have made what they make, nothing but
  // the end of its time ends a wait. A poll would look without end, and this would too.
  auto onlooker = std::make_shared<Onlooker>();
  node->get_node_waitables_interface()->add_waitable(onlooker, nullptr);
  int looks = 0;
  do {
    const int before = onlooker->looks;
    executor.spin_once(100ms);
    looks = onlooker->looks - before;
  } while (looks > 2);
  CHECK(looks > 0);
  return checks.finish();
}
