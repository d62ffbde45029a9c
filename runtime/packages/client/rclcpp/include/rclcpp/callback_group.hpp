// Which callbacks may run at the same time.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "rclcpp/context.hpp"
#include "rclcpp/guard_condition.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/visibility_control.hpp"

namespace rclcpp {

class SubscriptionBase;
class TimerBase;
class ServiceBase;
class ClientBase;
class Waitable;
class PublisherBase;

namespace node_interfaces {
class NodeServices;
class NodeTimers;
class NodeTopics;
class NodeWaitables;
}  // namespace node_interfaces

enum class CallbackGroupType { MutuallyExclusive, Reentrant };

class CallbackGroup {
  friend class rclcpp::node_interfaces::NodeServices;
  friend class rclcpp::node_interfaces::NodeTimers;
  friend class rclcpp::node_interfaces::NodeTopics;
  friend class rclcpp::node_interfaces::NodeWaitables;

 public:
  RCLCPP_SMART_PTR_DEFINITIONS(CallbackGroup)

  explicit CallbackGroup(CallbackGroupType group_type, rclcpp::Context::WeakPtr context,
                         bool automatically_add_to_executor_with_node = true);
  ~CallbackGroup();

  template <typename Function>
  std::shared_ptr<SubscriptionBase> find_subscription_ptrs_if(Function func) const {
    return find_if(func, subscriptions_);
  }
  template <typename Function>
  std::shared_ptr<TimerBase> find_timer_ptrs_if(Function func) const {
    return find_if(func, timers_);
  }
  template <typename Function>
  std::shared_ptr<ServiceBase> find_service_ptrs_if(Function func) const {
    return find_if(func, services_);
  }
  template <typename Function>
  std::shared_ptr<ClientBase> find_client_ptrs_if(Function func) const {
    return find_if(func, clients_);
  }
  template <typename Function>
  std::shared_ptr<Waitable> find_waitable_ptrs_if(Function func) const {
    return find_if(func, waitables_);
  }

  size_t size() const;
  /// False while a callback of a mutually exclusive group runs.
  std::atomic_bool& can_be_taken_from() { return can_be_taken_from_; }
  const CallbackGroupType& type() const { return type_; }
  void collect_all_ptrs(std::function<void(const std::shared_ptr<SubscriptionBase>&)> sub_func,
                        std::function<void(const std::shared_ptr<ServiceBase>&)> service_func,
                        std::function<void(const std::shared_ptr<ClientBase>&)> client_func,
                        std::function<void(const std::shared_ptr<TimerBase>&)> timer_func,
                        std::function<void(const std::shared_ptr<Waitable>&)> waitable_func) const;
  std::atomic_bool& get_associated_with_executor_atomic() { return associated_with_executor_; }
  bool automatically_add_to_executor_with_node() const {
    return automatically_add_to_executor_with_node_;
  }
  rclcpp::GuardCondition::SharedPtr get_notify_guard_condition();
  void trigger_notify_guard_condition();

 protected:
  RCLCPP_DISABLE_COPY(CallbackGroup)

  void add_publisher(const std::shared_ptr<PublisherBase>& publisher);
  void add_subscription(const std::shared_ptr<SubscriptionBase>& subscription);
  void add_timer(const std::shared_ptr<TimerBase>& timer);
  void add_service(const std::shared_ptr<ServiceBase>& service);
  void add_client(const std::shared_ptr<ClientBase>& client);
  void add_waitable(const std::shared_ptr<Waitable>& waitable);
  void remove_waitable(const std::shared_ptr<Waitable>& waitable) noexcept;

 private:
  template <typename EntityT, typename Function>
  std::shared_ptr<EntityT> find_if(Function& func,
                                   const std::vector<std::weak_ptr<EntityT>>& entities) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const auto& weak : entities) {
      auto entity = weak.lock();
      if (entity && func(entity)) {
        return entity;
      }
    }
    return nullptr;
  }

  const CallbackGroupType type_;
  mutable std::mutex mutex_;
  std::atomic_bool associated_with_executor_{false};
  std::atomic_bool can_be_taken_from_{true};
  const bool automatically_add_to_executor_with_node_;
  rclcpp::Context::WeakPtr context_;
  rclcpp::GuardCondition::SharedPtr notify_guard_condition_;
  std::vector<std::weak_ptr<SubscriptionBase>> subscriptions_;
  std::vector<std::weak_ptr<TimerBase>> timers_;
  std::vector<std::weak_ptr<ServiceBase>> services_;
  std::vector<std::weak_ptr<ClientBase>> clients_;
  std::vector<std::weak_ptr<Waitable>> waitables_;
};

}  // namespace rclcpp
