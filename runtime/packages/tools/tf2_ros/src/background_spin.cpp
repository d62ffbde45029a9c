// Callbacks while the program waits.
#include "tf2_ros/detail/background_spin.hpp"

#include <atomic>
#include <mutex>
#include <thread>
#include <utility>

#include "rclcpp/detail/background.hpp"
#include "rclcpp/executors/single_threaded_executor.hpp"
#include "rcpputils/scope_exit.hpp"

namespace tf2_ros {
namespace detail {
namespace {

rclcpp::ExecutorOptions options_of(
    const rclcpp::node_interfaces::NodeBaseInterface::SharedPtr& node_base) {
  rclcpp::ExecutorOptions options;
  options.context = node_base->get_context();
  return options;
}

}  // namespace

struct BackgroundSpin::State {
  State(rclcpp::CallbackGroup::SharedPtr spun,
        const rclcpp::node_interfaces::NodeBaseInterface::SharedPtr& node_base)
      : group(std::move(spun)), executor(options_of(node_base)) {
    executor.add_callback_group(group, node_base);
  }

  void run() {
    // A callback of the group that waits does not run the next one.
    if (is_mine()) {
      return;
    }
    asked = true;
    // If another thread is already running this, it looks again and does the rest.
    while (asked) {
      const std::unique_lock<std::mutex> lock(running, std::try_to_lock);
      if (!lock || ended) {
        return;
      }
      asked = false;
      runner = std::this_thread::get_id();
      is_running = true;
      RCPPUTILS_SCOPE_EXIT(is_running = false;);
      executor.spin_all(std::chrono::nanoseconds(0));
    }
  }

  // Whether this thread is in a callback of the group.
  bool is_mine() const { return is_running && runner == std::this_thread::get_id(); }

  // Nodes and executors do not keep their groups alive.
  const rclcpp::CallbackGroup::SharedPtr group;
  rclcpp::executors::SingleThreadedExecutor executor;
  std::mutex running;
  std::atomic<bool> asked{false};
  // A program without threads has no id that stands for none of them.
  std::atomic<bool> is_running{false};
  std::atomic<std::thread::id> runner{std::thread::id()};
  bool ended = false;
};

BackgroundSpin::BackgroundSpin(
    rclcpp::CallbackGroup::SharedPtr group,
    rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base,
    const std::vector<rclcpp::SubscriptionBase::SharedPtr>& subscriptions)
    : state_(std::make_shared<State>(std::move(group), node_base)) {
  for (const auto& subscription : subscriptions) {
    works_.push_back(rclcpp::detail::add_background(subscription->ready_endpoint(),
                                                    [state = state_] { state->run(); }));
  }
}

BackgroundSpin::~BackgroundSpin() {
  works_.clear();
  if (!state_->is_mine()) {
    const std::lock_guard<std::mutex> lock(state_->running);
    state_->ended = true;
  }
}

}  // namespace detail
}  // namespace tf2_ros
