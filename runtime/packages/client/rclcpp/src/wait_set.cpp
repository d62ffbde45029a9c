// The wait of wait sets.
#include "rclcpp/wait_set_template.hpp"

#include "rclcpp/detail/background.hpp"
#include "rclcpp/detail/listeners.hpp"
#include "ros2wasm/endpoint.hpp"

namespace rclcpp {
namespace detail {
namespace {

using std::chrono::nanoseconds;

template <typename EntityT>
void let_go(std::vector<std::weak_ptr<EntityT>>& entities) {
  for (const auto& weak : entities) {
    if (const auto entity = weak.lock()) {
      entity->exchange_in_use_by_wait_set_state(false);
    }
  }
}

template <typename EntityT>
void drop_expired(std::vector<std::weak_ptr<EntityT>>& entities) {
  entities.erase(std::remove_if(entities.begin(), entities.end(),
                                [](const auto& weak) { return weak.expired(); }),
                 entities.end());
}

// Marks the entities whose endpoint has data.
template <typename EntityT, typename RclT>
bool mark_ready(const std::vector<std::weak_ptr<EntityT>>& entities,
                const std::vector<uint32_t>& ready_ids, const RclT** flags) {
  bool any = false;
  for (size_t i = 0; i < entities.size(); ++i) {
    flags[i] = nullptr;
    const auto entity = entities[i].lock();
    if (!entity) {
      continue;
    }
    const auto id = static_cast<uint32_t>(entity->ready_endpoint());
    if (entity->is_ready_now() ||
        std::find(ready_ids.begin(), ready_ids.end(), id) != ready_ids.end()) {
      flags[i] = reinterpret_cast<const RclT*>(entity.get());
      any = true;
    }
  }
  return any;
}

}  // namespace

WaitSetCore::~WaitSetCore() {
  for (const auto& weak : subscriptions_) {
    if (const auto subscription = weak.lock()) {
      subscription->exchange_in_use_by_wait_set_state(subscription.get(), false);
    }
  }
  let_go(guard_conditions_);
  let_go(timers_);
  let_go(clients_);
  let_go(services_);
  let_go(waitables_);
}

void WaitSetCore::changed() {
  rebuild_view();
  ros2wasm::wake();
}

void WaitSetCore::rebuild_view() {
  view_.subscriptions = subscriptions_.size();
  view_.guard_conditions = guard_conditions_.size();
  view_.timers = timers_.size();
  view_.clients = clients_.size();
  view_.services = services_.size();
  view_.events = 0;
  for (const auto& weak : waitables_) {
    if (const auto waitable = weak.lock()) {
      view_.reserve(*waitable);
    }
  }
  view_.clear();
  ready_waitables_.assign(waitables_.size(), 0);
}

void WaitSetCore::add_subscription(std::shared_ptr<rclcpp::SubscriptionBase> subscription,
                                   const rclcpp::SubscriptionWaitSetMask& mask) {
  if (!subscription) {
    throw std::invalid_argument("subscription is nullptr");
  }
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  if (mask.include_subscription) {
    if (subscription->exchange_in_use_by_wait_set_state(subscription.get(), true)) {
      throw std::runtime_error("subscription already associated with a wait set");
    }
    subscriptions_.push_back(subscription);
  }
  if (mask.include_events) {
    for (const auto& [type, handler] : subscription->get_event_handlers()) {
      if (handler->exchange_in_use_by_wait_set_state(true)) {
        throw std::runtime_error("subscription event already associated with a wait set");
      }
      waitables_.push_back(handler);
    }
  }
  changed();
}

void WaitSetCore::remove_subscription(const std::shared_ptr<rclcpp::SubscriptionBase>& subscription,
                                      const rclcpp::SubscriptionWaitSetMask& mask) {
  if (!subscription) {
    throw std::invalid_argument("subscription is nullptr");
  }
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  if (mask.include_subscription) {
    const auto found = std::find_if(subscriptions_.begin(), subscriptions_.end(),
                                    [&](const auto& weak) { return weak.lock() == subscription; });
    if (found == subscriptions_.end()) {
      throw std::runtime_error("subscription not in wait set");
    }
    subscription->exchange_in_use_by_wait_set_state(subscription.get(), false);
    subscriptions_.erase(found);
  }
  if (mask.include_events) {
    for (const auto& [type, handler] : subscription->get_event_handlers()) {
      remove_waitable(handler);
    }
  }
  changed();
}

void WaitSetCore::add_waitable(std::shared_ptr<rclcpp::Waitable> waitable, std::shared_ptr<void>) {
  add(waitables_, std::move(waitable), "waitable is nullptr",
      "waitable already in use by another wait set");
}

void WaitSetCore::remove_waitable(const std::shared_ptr<rclcpp::Waitable>& waitable) {
  remove(waitables_, waitable, "waitable is nullptr", "waitable not in wait set");
}

void WaitSetCore::prune() {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  drop_expired(subscriptions_);
  drop_expired(guard_conditions_);
  drop_expired(timers_);
  drop_expired(clients_);
  drop_expired(services_);
  drop_expired(waitables_);
  changed();
}

bool WaitSetCore::look_at_guards() {
  for (const auto& weak : guard_conditions_) {
    if (const auto guard = weak.lock()) {
      guard->add_to_wait_set(view_.handle);
    }
  }
  for (const auto& weak : waitables_) {
    if (const auto waitable = weak.lock()) {
      waitable->add_to_wait_set(view_.handle);
    }
  }
  bool any = view_.take_triggers();
  for (size_t i = 0; i < waitables_.size(); ++i) {
    const auto waitable = waitables_[i].lock();
    ready_waitables_[i] =
        waitable && waitable->is_ready(static_cast<const rcl_wait_set_t&>(view_.handle));
    any = any || ready_waitables_[i] != 0;
  }
  return any;
}

bool WaitSetCore::look(nanoseconds& next_timer) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  ros2wasm::ready_endpoints(ready_ids_);
  for (const uint32_t id : ready_ids_) {
    run_background(id);
  }
  // Waitables may say each time how much room they need.
  rebuild_view();
  bool any = look_at_guards();
  any = mark_ready(subscriptions_, ready_ids_, view_.handle.subscriptions) || any;
  any = mark_ready(clients_, ready_ids_, view_.handle.clients) || any;
  any = mark_ready(services_, ready_ids_, view_.handle.services) || any;
  next_timer = nanoseconds::max();
  for (size_t i = 0; i < timers_.size(); ++i) {
    const auto timer = timers_[i].lock();
    const nanoseconds left = timer ? timer->time_until_trigger() : nanoseconds::max();
    if (left.count() <= 0) {
      view_.handle.timers[i] = reinterpret_cast<const rcl_timer_t*>(timer.get());
      any = true;
    } else if (timer && !timer->get_clock()->ros_time_is_active()) {
      next_timer = std::min(next_timer, left);
    }
  }
  return any;
}

WaitResultKind WaitSetCore::wait(nanoseconds timeout) {
  if (held_) {
    throw std::runtime_error("wait_result_acquire() called while already holding");
  }
  const bool limited = timeout.count() >= 0;
  const nanoseconds until = nanoseconds(ros2wasm::steady_now_ns()) + timeout;
  while (true) {
    const int32_t token = ros2wasm::wake_token();
    nanoseconds limit = nanoseconds::max();
    look_for_listeners();
    if (look(limit)) {
      return WaitResultKind::Ready;
    }
    if (!context_->is_valid()) {
      return WaitResultKind::Timeout;
    }
    {
      const std::lock_guard<std::recursive_mutex> lock(mutex_);
      if (subscriptions_.empty() && guard_conditions_.empty() && timers_.empty() &&
          clients_.empty() && services_.empty() && waitables_.empty()) {
        return WaitResultKind::Empty;
      }
    }
    if (limited) {
      const nanoseconds left = until - nanoseconds(ros2wasm::steady_now_ns());
      if (left.count() <= 0) {
        return WaitResultKind::Timeout;
      }
      limit = std::min(limit, left);
    }
    ros2wasm::wait(token, limit == nanoseconds::max() ? -1 : limit.count());
  }
}

void WaitSetCore::acquire() {
  held_ = true;
}

void WaitSetCore::release() {
  held_ = false;
}

}  // namespace detail
}  // namespace rclcpp
