// Callback groups.
#include "rclcpp/callback_group.hpp"

#include <algorithm>
#include <stdexcept>

#include "rclcpp/client.hpp"
#include "rclcpp/detail/executable.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp/subscription_base.hpp"
#include "rclcpp/timer.hpp"
#include "rclcpp/waitable.hpp"
#include "ros2wasm/endpoint.hpp"

namespace rclcpp {
namespace {

std::atomic<uint32_t> g_entities_version{1};

template <typename EntityT>
void add_to(std::vector<std::weak_ptr<EntityT>>& entities, const std::shared_ptr<EntityT>& entity) {
  entities.erase(std::remove_if(entities.begin(), entities.end(),
                                [](const std::weak_ptr<EntityT>& weak) { return weak.expired(); }),
                 entities.end());
  entities.push_back(entity);
}

template <typename EntityT, typename FunctionT>
void visit(const std::vector<std::weak_ptr<EntityT>>& entities, const FunctionT& function) {
  for (const auto& weak : entities) {
    if (const auto entity = weak.lock()) {
      function(entity);
    }
  }
}

}  // namespace

uint32_t detail::entities_version() {
  return g_entities_version;
}

void detail::bump_entities_version() {
  ++g_entities_version;
  ros2wasm::wake();
}

CallbackGroup::CallbackGroup(CallbackGroupType group_type, rclcpp::Context::WeakPtr context,
                             bool automatically_add_to_executor_with_node)
    : type_(group_type),
      automatically_add_to_executor_with_node_(automatically_add_to_executor_with_node),
      context_(std::move(context)) {}

CallbackGroup::~CallbackGroup() {
  detail::bump_entities_version();
}

size_t CallbackGroup::size() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return subscriptions_.size() + timers_.size() + services_.size() + clients_.size() +
         waitables_.size();
}

void CallbackGroup::collect_all_ptrs(
    std::function<void(const std::shared_ptr<SubscriptionBase>&)> sub_func,
    std::function<void(const std::shared_ptr<ServiceBase>&)> service_func,
    std::function<void(const std::shared_ptr<ClientBase>&)> client_func,
    std::function<void(const std::shared_ptr<TimerBase>&)> timer_func,
    std::function<void(const std::shared_ptr<Waitable>&)> waitable_func) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  visit(subscriptions_, sub_func);
  visit(services_, service_func);
  visit(clients_, client_func);
  visit(timers_, timer_func);
  visit(waitables_, waitable_func);
}

rclcpp::GuardCondition::SharedPtr CallbackGroup::get_notify_guard_condition() {
  const auto context = context_.lock();
  if (!context || !context->is_valid()) {
    return nullptr;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!notify_guard_condition_) {
    notify_guard_condition_ = std::make_shared<rclcpp::GuardCondition>(context);
  }
  return notify_guard_condition_;
}

void CallbackGroup::trigger_notify_guard_condition() {
  detail::bump_entities_version();
}

void CallbackGroup::add_publisher(const std::shared_ptr<PublisherBase>&) {}

void CallbackGroup::add_subscription(const std::shared_ptr<SubscriptionBase>& subscription) {
  const std::lock_guard<std::mutex> lock(mutex_);
  add_to(subscriptions_, subscription);
}

void CallbackGroup::add_timer(const std::shared_ptr<TimerBase>& timer) {
  const std::lock_guard<std::mutex> lock(mutex_);
  add_to(timers_, timer);
}

void CallbackGroup::add_service(const std::shared_ptr<ServiceBase>& service) {
  const std::lock_guard<std::mutex> lock(mutex_);
  add_to(services_, service);
}

void CallbackGroup::add_client(const std::shared_ptr<ClientBase>& client) {
  const std::lock_guard<std::mutex> lock(mutex_);
  add_to(clients_, client);
}

void CallbackGroup::add_waitable(const std::shared_ptr<Waitable>& waitable) {
  const std::lock_guard<std::mutex> lock(mutex_);
  add_to(waitables_, waitable);
}

void CallbackGroup::remove_waitable(const std::shared_ptr<Waitable>& waitable) noexcept {
  const std::lock_guard<std::mutex> lock(mutex_);
  waitables_.erase(std::remove_if(waitables_.begin(), waitables_.end(),
                                  [&](const std::weak_ptr<Waitable>& weak) {
                                    return weak.expired() || weak.lock() == waitable;
                                  }),
                   waitables_.end());
}

}  // namespace rclcpp
