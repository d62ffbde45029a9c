// Wait sets: wait for chosen entities without an executor.
#pragma once

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "rclcpp/client.hpp"
#include "rclcpp/contexts/default_context.hpp"
#include "rclcpp/guard_condition.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp/subscription_base.hpp"
#include "rclcpp/subscription_wait_set_mask.hpp"
#include "rclcpp/timer.hpp"
#include "rclcpp/wait_result.hpp"
#include "rclcpp/wait_set_policies/detail/entries.hpp"
#include "rclcpp/waitable.hpp"

namespace rclcpp {

namespace detail {

/// The entities of a wait set and the wait itself; not a template, so that it exists once.
class WaitSetCore {
 public:
  explicit WaitSetCore(rclcpp::Context::SharedPtr context) : context_(std::move(context)) {}
  ~WaitSetCore();

  void add_subscription(std::shared_ptr<rclcpp::SubscriptionBase> subscription,
                        const rclcpp::SubscriptionWaitSetMask& mask);
  void remove_subscription(const std::shared_ptr<rclcpp::SubscriptionBase>& subscription,
                           const rclcpp::SubscriptionWaitSetMask& mask);
  void add_waitable(std::shared_ptr<rclcpp::Waitable> waitable,
                    std::shared_ptr<void> associated_entity);
  void remove_waitable(const std::shared_ptr<rclcpp::Waitable>& waitable);

  template <typename EntityT>
  void add(std::vector<std::weak_ptr<EntityT>>& entities, std::shared_ptr<EntityT> entity,
           const char* null_text, const char* used_text) {
    if (!entity) {
      throw std::invalid_argument(null_text);
    }
    if (entity->exchange_in_use_by_wait_set_state(true)) {
      throw std::runtime_error(used_text);
    }
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    entities.push_back(std::move(entity));
    changed();
  }
  template <typename EntityT>
  void remove(std::vector<std::weak_ptr<EntityT>>& entities, const std::shared_ptr<EntityT>& entity,
              const char* null_text, const char* absent_text) {
    if (!entity) {
      throw std::invalid_argument(null_text);
    }
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    const auto found = std::find_if(entities.begin(), entities.end(),
                                    [&](const auto& weak) { return weak.lock() == entity; });
    if (found == entities.end()) {
      throw std::runtime_error(absent_text);
    }
    entity->exchange_in_use_by_wait_set_state(false);
    entities.erase(found);
    changed();
  }
  void prune();

  /// Ready, Timeout or Empty.
  WaitResultKind wait(std::chrono::nanoseconds timeout);
  void acquire();
  void release();

  std::vector<std::weak_ptr<rclcpp::SubscriptionBase>> subscriptions_;
  std::vector<std::weak_ptr<rclcpp::GuardCondition>> guard_conditions_;
  std::vector<std::weak_ptr<rclcpp::TimerBase>> timers_;
  std::vector<std::weak_ptr<rclcpp::ClientBase>> clients_;
  std::vector<std::weak_ptr<rclcpp::ServiceBase>> services_;
  std::vector<std::weak_ptr<rclcpp::Waitable>> waitables_;
  /// The entities that are ready: subscriptions, timers, clients and services by their addresses.
  /// The guard conditions of this wait set come first, then those of the waitables.
  RclWaitSet view_;
  /// Ready and not handed out yet.
  std::vector<char> ready_waitables_;

 private:
  void changed();
  bool look(std::chrono::nanoseconds& next_timer);
  bool look_at_guards();
  void rebuild_view();

  rclcpp::Context::SharedPtr context_;
  std::recursive_mutex mutex_;
  bool held_ = false;
  std::vector<uint32_t> ready_ids_;
};

}  // namespace detail

/// The policies are those of wait_set_policies/: what may be added later, and by whom. All wait
/// sets here may be changed by other threads.
template <class SynchronizationPolicy, class StoragePolicy>
class WaitSetTemplate final {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(WaitSetTemplate)

  using SubscriptionEntry = typename StoragePolicy::SubscriptionEntry;
  using WaitableEntry = typename StoragePolicy::WaitableEntry;

  explicit WaitSetTemplate(
      const typename StoragePolicy::SubscriptionsIterable& subscriptions = {},
      const typename StoragePolicy::GuardConditionsIterable& guard_conditions = {},
      const typename StoragePolicy::TimersIterable& timers = {},
      const typename StoragePolicy::ClientsIterable& clients = {},
      const typename StoragePolicy::ServicesIterable& services = {},
      const typename StoragePolicy::WaitablesIterable& waitables = {},
      rclcpp::Context::SharedPtr context = rclcpp::contexts::get_global_default_context())
      : core_(std::move(context)) {
    for (const auto& entry : subscriptions) {
      core_.add_subscription(entry.subscription, entry.mask);
    }
    for (const auto& entity : guard_conditions) {
      core_.add(core_.guard_conditions_, entity, kNoGuard, kGuardUsed);
    }
    for (const auto& entity : timers) {
      core_.add(core_.timers_, entity, kNoTimer, kTimerUsed);
    }
    for (const auto& entity : clients) {
      core_.add(core_.clients_, entity, kNoClient, kClientUsed);
    }
    for (const auto& entity : services) {
      core_.add(core_.services_, entity, kNoService, kServiceUsed);
    }
    for (const auto& entry : waitables) {
      core_.add_waitable(entry.waitable, entry.associated_entity);
    }
  }

  const rcl_wait_set_t& get_rcl_wait_set() const { return core_.view_.handle; }

  void add_subscription(std::shared_ptr<rclcpp::SubscriptionBase> subscription,
                        rclcpp::SubscriptionWaitSetMask mask = {}) {
    require_dynamic();
    core_.add_subscription(std::move(subscription), mask);
  }
  void remove_subscription(std::shared_ptr<rclcpp::SubscriptionBase> subscription,
                           rclcpp::SubscriptionWaitSetMask mask = {}) {
    require_dynamic();
    core_.remove_subscription(subscription, mask);
  }
  void add_guard_condition(std::shared_ptr<rclcpp::GuardCondition> guard_condition) {
    require_dynamic();
    core_.add(core_.guard_conditions_, std::move(guard_condition), kNoGuard, kGuardUsed);
  }
  void remove_guard_condition(std::shared_ptr<rclcpp::GuardCondition> guard_condition) {
    require_dynamic();
    core_.remove(core_.guard_conditions_, guard_condition, kNoGuard,
                 "guard_condition not in wait set");
  }
  void add_timer(std::shared_ptr<rclcpp::TimerBase> timer) {
    require_dynamic();
    core_.add(core_.timers_, std::move(timer), kNoTimer, kTimerUsed);
  }
  void remove_timer(std::shared_ptr<rclcpp::TimerBase> timer) {
    require_dynamic();
    core_.remove(core_.timers_, timer, kNoTimer, "timer not in wait set");
  }
  void add_client(std::shared_ptr<rclcpp::ClientBase> client) {
    require_dynamic();
    core_.add(core_.clients_, std::move(client), kNoClient, kClientUsed);
  }
  void remove_client(std::shared_ptr<rclcpp::ClientBase> client) {
    require_dynamic();
    core_.remove(core_.clients_, client, kNoClient, "client not in wait set");
  }
  void add_service(std::shared_ptr<rclcpp::ServiceBase> service) {
    require_dynamic();
    core_.add(core_.services_, std::move(service), kNoService, kServiceUsed);
  }
  void remove_service(std::shared_ptr<rclcpp::ServiceBase> service) {
    require_dynamic();
    core_.remove(core_.services_, service, kNoService, "service not in wait set");
  }
  void add_waitable(std::shared_ptr<rclcpp::Waitable> waitable,
                    std::shared_ptr<void> associated_entity = nullptr) {
    require_dynamic();
    core_.add_waitable(std::move(waitable), std::move(associated_entity));
  }
  void remove_waitable(std::shared_ptr<rclcpp::Waitable> waitable) {
    require_dynamic();
    core_.remove_waitable(waitable);
  }
  void prune_deleted_entities() { core_.prune(); }

  /// Negative: waits for ever. The result holds the wait set until it is gone.
  template <class Rep = int64_t, class Period = std::milli>
  [[nodiscard]] WaitResult<WaitSetTemplate> wait(
      std::chrono::duration<Rep, Period> time_to_wait = std::chrono::duration<Rep, Period>(-1)) {
    switch (core_.wait(std::chrono::duration_cast<std::chrono::nanoseconds>(time_to_wait))) {
      case WaitResultKind::Ready:
        return WaitResult<WaitSetTemplate>::from_ready_wait_result_kind(*this);
      case WaitResultKind::Empty:
        return WaitResult<WaitSetTemplate>::from_empty_wait_result_kind();
      default:
        return WaitResult<WaitSetTemplate>::from_timeout_wait_result_kind();
    }
  }

  size_t size_of_subscriptions() const { return core_.subscriptions_.size(); }
  size_t size_of_timers() const { return core_.timers_.size(); }
  size_t size_of_clients() const { return core_.clients_.size(); }
  size_t size_of_services() const { return core_.services_.size(); }
  size_t size_of_waitables() const { return core_.waitables_.size(); }
  std::shared_ptr<rclcpp::SubscriptionBase> subscriptions(size_t i) const {
    return core_.subscriptions_[i].lock();
  }
  std::shared_ptr<rclcpp::TimerBase> timers(size_t i) const { return core_.timers_[i].lock(); }
  std::shared_ptr<rclcpp::ClientBase> clients(size_t i) const { return core_.clients_[i].lock(); }
  std::shared_ptr<rclcpp::ServiceBase> services(size_t i) const {
    return core_.services_[i].lock();
  }
  std::shared_ptr<rclcpp::Waitable> waitables(size_t i) const { return core_.waitables_[i].lock(); }

 private:
  RCLCPP_DISABLE_COPY(WaitSetTemplate)
  friend class WaitResult<WaitSetTemplate>;

  static constexpr void require_dynamic() {
    static_assert(!StoragePolicy::kFixed,
                  "a static wait set gets its entities in the constructor only");
  }
  rcl_wait_set_t& ready_view() { return core_.view_.handle; }
  /// Whether it is ready; then it is no more.
  bool take_waitable(size_t i) { return std::exchange(core_.ready_waitables_.at(i), 0) != 0; }
  void wait_result_acquire() { core_.acquire(); }
  void wait_result_release() { core_.release(); }

  static constexpr const char* kNoGuard = "guard_condition is nullptr";
  static constexpr const char* kGuardUsed = "guard condition already in use by another wait set";
  static constexpr const char* kNoTimer = "timer is nullptr";
  static constexpr const char* kTimerUsed = "timer already in use by another wait set";
  static constexpr const char* kNoClient = "client is nullptr";
  static constexpr const char* kClientUsed = "client already in use by another wait set";
  static constexpr const char* kNoService = "service is nullptr";
  static constexpr const char* kServiceUsed = "service already in use by another wait set";

  detail::WaitSetCore core_;
};

}  // namespace rclcpp
