// The kinds of wait sets and their policies.

// Compatibility, works: `WaitSetTemplate` with the policies of `rclcpp::wait_set_policies`

#include <array>
#include <memory>

#include "checks.hpp"
#include "rclcpp/wait_set_policies/dynamic_storage.hpp"
#include "rclcpp/wait_set_policies/sequential_synchronization.hpp"
#include "rclcpp/wait_set_policies/static_storage.hpp"
#include "rclcpp/wait_set_policies/thread_safe_synchronization.hpp"
#include "rclcpp/wait_set_template.hpp"
#include "std_msgs/msg/string.hpp"

using std_msgs::msg::String;
using namespace std::chrono_literals;

namespace {

template <class WaitSetT>
bool finds(WaitSetT& wait_set, const rclcpp::SubscriptionBase::SharedPtr& subscription) {
  auto result = wait_set.wait(10s);
  return result.kind() == rclcpp::WaitResultKind::Ready &&
         result.next_ready_subscription() == subscription;
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("wait_sets");
  auto node = std::make_shared<rclcpp::Node>("wait_sets_node");
  auto publisher = node->create_publisher<String>("~/bell", 10);
  auto subscription = node->create_subscription<String>("~/bell", 10, [](const String&) {});
  auto guard = std::make_shared<rclcpp::GuardCondition>();
  auto timer = node->create_wall_timer(1h, [] {});
  String taken;
  rclcpp::MessageInfo info;

  using Dynamic = rclcpp::WaitSetTemplate<rclcpp::wait_set_policies::SequentialSynchronization,
                                          rclcpp::wait_set_policies::DynamicStorage>;
  static_assert(std::is_same_v<Dynamic, rclcpp::WaitSet>);
  {
    Dynamic wait_set(std::vector<Dynamic::SubscriptionEntry>{{subscription}},
                     std::vector<rclcpp::GuardCondition::SharedPtr>{guard}, {timer});
    publisher->publish(String());
    CHECK(finds(wait_set, subscription));
    CHECK(subscription->take(taken, info));
    CHECK_THROWS(std::runtime_error, rclcpp::ThreadSafeWaitSet({{subscription}}));
    wait_set.remove_subscription(subscription);
    CHECK_THROWS(std::runtime_error, wait_set.remove_subscription(subscription));
    CHECK(wait_set.wait(1ms).kind() == rclcpp::WaitResultKind::Timeout);
    // What is gone counts for nothing any more.
    guard.reset();
    wait_set.prune_deleted_entities();
    wait_set.remove_timer(timer);
    CHECK(wait_set.wait(1ms).kind() == rclcpp::WaitResultKind::Empty);
    guard = std::make_shared<rclcpp::GuardCondition>();
  }
  {
    using Fixed = rclcpp::StaticWaitSet<1, 1, 0, 0, 0, 0>;
    static_assert(
        std::is_same_v<Fixed, rclcpp::WaitSetTemplate<
                                  rclcpp::wait_set_policies::SequentialSynchronization,
                                  rclcpp::wait_set_policies::StaticStorage<1, 1, 0, 0, 0, 0>>>);
    Fixed wait_set(std::array<Fixed::SubscriptionEntry, 1>{{{subscription}}},
                   std::array<rclcpp::GuardCondition::SharedPtr, 1>{guard});
    CHECK(wait_set.wait(1ms).kind() == rclcpp::WaitResultKind::Timeout);
    publisher->publish(String());
    CHECK(finds(wait_set, subscription));
    CHECK(subscription->take(taken, info));
    guard->trigger();
    auto result = wait_set.wait(10s);
    CHECK(result.get_wait_set().get_rcl_wait_set().guard_conditions[0] ==
          &guard->get_rcl_guard_condition());
  }
  {
    rclcpp::ThreadSafeWaitSet wait_set;
    wait_set.add_subscription(subscription);
    publisher->publish(String());
    CHECK(finds(wait_set, subscription));
    CHECK(subscription->take(taken, info));
  }
  return checks.finish();
}
