// Executors: wait for work of their nodes and run it. This base knows how; the kinds differ in the
// threads that they use.
#pragma once

#include <atomic>
#include <cassert>
#include <chrono>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "rclcpp/any_executable.hpp"
#include "rclcpp/callback_group.hpp"
#include "rclcpp/executor_options.hpp"
#include "rclcpp/future_return_code.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/utilities.hpp"

namespace rclcpp {

class Node;

class Executor {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(Executor)

  explicit Executor(const rclcpp::ExecutorOptions& options = rclcpp::ExecutorOptions());
  virtual ~Executor();

  virtual void spin() = 0;

  virtual void add_callback_group(rclcpp::CallbackGroup::SharedPtr group_ptr,
                                  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_ptr,
                                  bool notify = true);
  virtual void remove_callback_group(rclcpp::CallbackGroup::SharedPtr group_ptr,
                                     bool notify = true);
  virtual std::vector<rclcpp::CallbackGroup::WeakPtr> get_all_callback_groups();
  virtual std::vector<rclcpp::CallbackGroup::WeakPtr> get_manually_added_callback_groups();
  virtual std::vector<rclcpp::CallbackGroup::WeakPtr>
  get_automatically_added_callback_groups_from_nodes();

  /// Throws std::runtime_error when the node already is with an executor.
  virtual void add_node(rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_ptr,
                        bool notify = true);
  virtual void add_node(std::shared_ptr<rclcpp::Node> node_ptr, bool notify = true);
  virtual void remove_node(rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_ptr,
                           bool notify = true);
  virtual void remove_node(std::shared_ptr<rclcpp::Node> node_ptr, bool notify = true);

  template <typename RepT = int64_t, typename T = std::milli>
  void spin_node_once(rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node,
                      std::chrono::duration<RepT, T> timeout = std::chrono::duration<RepT, T>(-1)) {
    spin_node_once_nanoseconds(node, std::chrono::duration_cast<std::chrono::nanoseconds>(timeout));
  }
  template <typename NodeT = rclcpp::Node, typename RepT = int64_t, typename T = std::milli>
  void spin_node_once(std::shared_ptr<NodeT> node,
                      std::chrono::duration<RepT, T> timeout = std::chrono::duration<RepT, T>(-1)) {
    spin_node_once_nanoseconds(node->get_node_base_interface(),
                               std::chrono::duration_cast<std::chrono::nanoseconds>(timeout));
  }
  void spin_node_some(rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node);
  void spin_node_some(std::shared_ptr<rclcpp::Node> node);
  void spin_node_all(rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node,
                     std::chrono::nanoseconds max_duration);
  void spin_node_all(std::shared_ptr<rclcpp::Node> node, std::chrono::nanoseconds max_duration);

  /// Runs what is ready now, each thing once.
  virtual void spin_some(std::chrono::nanoseconds max_duration = std::chrono::nanoseconds(0));
  /// Runs until nothing is ready or the time is over.
  virtual void spin_all(std::chrono::nanoseconds max_duration);
  virtual void spin_once(std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));

  template <typename FutureT, typename TimeRepT = int64_t, typename TimeT = std::milli>
  FutureReturnCode spin_until_future_complete(
      const FutureT& future,
      std::chrono::duration<TimeRepT, TimeT> timeout = std::chrono::duration<TimeRepT, TimeT>(-1)) {
    return spin_until_future_complete_impl(
        std::chrono::duration_cast<std::chrono::nanoseconds>(timeout),
        [&future](std::chrono::nanoseconds wait_time) { return future.wait_for(wait_time); });
  }

  /// Makes a running spin return. May be called from any thread.
  virtual void cancel();
  bool is_spinning();

 protected:
  RCLCPP_DISABLE_COPY(Executor)

  struct Entry {
    std::weak_ptr<detail::Executable> entity;
    std::weak_ptr<rclcpp::CallbackGroup> group;
    int32_t endpoint_id;
    bool polls;
    bool follows_status;
    bool is_timer;
    // When it was asked last; at first it must be asked.
    bool was_ready = true;
  };

  FutureReturnCode spin_until_future_complete_impl(
      std::chrono::nanoseconds timeout,
      const std::function<std::future_status(std::chrono::nanoseconds)>& wait_for_future);
  void spin_node_once_nanoseconds(rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node,
                                  std::chrono::nanoseconds timeout);
  void spin_some_impl(std::chrono::nanoseconds max_duration, bool exhaustive);
  virtual void spin_once_impl(std::chrono::nanoseconds timeout);
  /// Waits until something can run. False: timeout, cancelled or shut down. Negative: no limit.
  bool get_next_executable(AnyExecutable& any_executable,
                           std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));
  /// False: there was nothing to do after all.
  bool execute_any_executable(AnyExecutable& any_executable);
  /// Called by execute_any_executable() to run it.
  virtual bool run_executable(AnyExecutable& any_executable);

  std::atomic_bool spinning{false};
  const rclcpp::Context::SharedPtr context_;

 private:
  struct NodeRecord {
    rclcpp::node_interfaces::NodeBaseInterface::WeakPtr node;
    // Its groups that came with it.
    std::vector<rclcpp::CallbackGroup::WeakPtr> groups;
  };

  void refresh_entries();
  void add_entries_of(const rclcpp::CallbackGroup::SharedPtr& group);
  /// Notes what is ready. Returns the time until the next timer, or max. While no event has come
  /// since `token`, what had something to read may have more, and nothing else has: then the bus is
  /// not asked again. Without a token it is.
  std::chrono::nanoseconds collect_ready(std::optional<int32_t> token);
  void ask_bus(std::optional<int32_t> token);
  /// Each once, in the order of entries_.
  void add_ready(size_t entry);
  bool take_ready(AnyExecutable& any_executable);
  void release_group(const rclcpp::CallbackGroup::WeakPtr& weak);

  std::atomic<int> seekers_{0};
  std::mutex mutex_;
  std::vector<NodeRecord> nodes_;
  std::vector<rclcpp::CallbackGroup::WeakPtr> manual_groups_;
  uint32_t seen_version_ = 0;
  int32_t seen_status_ = 0;
  std::vector<Entry> entries_;
  std::map<int32_t, size_t> entry_of_endpoint_;
  // Those that are asked in each round, timers first.
  std::vector<size_t> polling_;
  std::vector<size_t> ready_;
  size_t next_ready_ = 0;
  std::vector<uint32_t> ready_endpoints_;
  std::vector<size_t> ready_entries_;
  // The token before the bus was asked; none: it must be asked again.
  std::optional<int32_t> asked_at_;
  // The last collect_ready() did without.
  bool spared_ = false;
  unsigned spared_rounds_ = 0;  // in a row
  rclcpp::OnShutdownCallbackHandle shutdown_callback_;
};

}  // namespace rclcpp
