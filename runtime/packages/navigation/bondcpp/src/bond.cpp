// Heartbeats, timers and callbacks of one end of a bond.
#include "bondcpp/bond.hpp"

#include <algorithm>
#include <chrono>
#include <random>
#include <utility>

namespace bond {
namespace {

using namespace std::chrono_literals;
using Constants = bond::msg::Constants;

constexpr std::chrono::nanoseconds kLook = 10ms;
constexpr std::chrono::nanoseconds kLastWords = 100ms;
constexpr std::size_t kStatusesSent = 5;
constexpr std::size_t kStatusesHeard = 100;

/// A random UUID (version 4) as text.
std::string make_uuid() {
  constexpr char kDigits[] = "0123456789abcdef";
  constexpr std::size_t kLength = 36;
  constexpr std::size_t kVersion = 14;
  constexpr std::size_t kVariant = 19;
  std::random_device device;
  std::string uuid(kLength, '-');
  for (std::size_t i = 0; i < kLength; ++i) {
    if (i == 8 || i == 13 || i == 18 || i == 23) continue;
    uuid[i] = kDigits[i == kVariant ? 8 + device() % 4 : device() % 16];
  }
  uuid[kVersion] = '4';
  return uuid;
}

std::chrono::nanoseconds nanoseconds_of(double seconds) {
  return rclcpp::Duration::from_seconds(std::max(seconds, 0.0))
      .to_chrono<std::chrono::nanoseconds>();
}

void cancel(const rclcpp::TimerBase::SharedPtr& timer) {
  if (timer) timer->cancel();
}

}  // namespace

Bond::Bond(const std::string& topic, const std::string& id,
           rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base,
           rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr node_logging,
           rclcpp::node_interfaces::NodeParametersInterface::SharedPtr node_params,
           rclcpp::node_interfaces::NodeTimersInterface::SharedPtr node_timers,
           rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr node_topics,
           EventCallback on_broken, EventCallback on_formed,
           rclcpp::CallbackGroup::SharedPtr callback_group)
    : node_base_(std::move(node_base)),
      node_logging_(std::move(node_logging)),
      node_timers_(std::move(node_timers)),
      node_topics_(std::move(node_topics)),
      callback_group_(std::move(callback_group)),
      topic_(topic),
      id_(id),
      instance_id_(make_uuid()),
      on_broken_(std::move(on_broken)),
      on_formed_(std::move(on_formed)) {
  const std::string parameter = Constants::DISABLE_HEARTBEAT_TIMEOUT_PARAM;
  if (!node_params->has_parameter(parameter)) {
    node_params->declare_parameter(parameter, rclcpp::ParameterValue(false));
  }
  ignores_silence_ = node_params->get_parameter(parameter).as_bool();
  setupConnections();
  publisher_ = rclcpp::create_publisher<bond::msg::Status>(
      node_topics_, topic_, rclcpp::QoS(rclcpp::KeepLast(kStatusesSent)));
}

/// Another thread may run a callback while the last owner lets go: a bond that is shared is then
/// kept until the callback ends, and one that is gone is not called.
void Bond::subscribe() {
  rclcpp::SubscriptionOptions options;
  options.callback_group = callback_group_;
  const bool is_shared = !weak_from_this().expired();
  subscription_ = rclcpp::create_subscription<bond::msg::Status>(
      node_topics_, topic_, rclcpp::QoS(kStatusesHeard),
      [this, is_shared, weak = weak_from_this()](const bond::msg::Status& status) {
        const auto self = weak.lock();
        if (self || !is_shared) receive(status);
      },
      options);
}

Bond::Bond(const std::string& topic, const std::string& id,
           rclcpp_lifecycle::LifecycleNode::SharedPtr nh, EventCallback on_broken,
           EventCallback on_formed)
    : Bond(topic, id, nh->get_node_base_interface(), nh->get_node_logging_interface(),
           nh->get_node_parameters_interface(), nh->get_node_timers_interface(),
           nh->get_node_topics_interface(), std::move(on_broken), std::move(on_formed)) {}

Bond::Bond(const std::string& topic, const std::string& id, rclcpp::Node::SharedPtr nh,
           EventCallback on_broken, EventCallback on_formed)
    : Bond(topic, id, nh->get_node_base_interface(), nh->get_node_logging_interface(),
           nh->get_node_parameters_interface(), nh->get_node_timers_interface(),
           nh->get_node_topics_interface(), std::move(on_broken), std::move(on_formed)) {}

Bond::~Bond() {
  if (!started_) return;
  breakBond();
  if (rclcpp::ok() && !waitUntilBroken(rclcpp::Duration(kLastWords))) {
    RCLCPP_DEBUG(node_logging_->get_logger(), "Bond failed to break on destruction %s (%s)",
                 id_.c_str(), instance_id_.c_str());
  }
  publishingTimerCancel();
  deadpublishingTimerCancel();
  connectTimerCancel();
  heartbeatTimerCancel();
  disconnectTimerCancel();
}

void Bond::setupConnections() {
  setConnectTimeout(Constants::DEFAULT_CONNECT_TIMEOUT);
  setDisconnectTimeout(Constants::DEFAULT_DISCONNECT_TIMEOUT);
  setHeartbeatTimeout(Constants::DEFAULT_HEARTBEAT_TIMEOUT);
  setHeartbeatPeriod(Constants::DEFAULT_HEARTBEAT_PERIOD);
  setDeadPublishPeriod(Constants::DEAD_PUBLISH_PERIOD);
}

void Bond::set_time(double& time, double value) {
  if (started_) {
    RCLCPP_ERROR(node_logging_->get_logger(), "Cannot set timeouts after calling start()");
    return;
  }
  time = value;
}

void Bond::setConnectTimeout(double dur) {
  set_time(times_.connect, dur);
}
void Bond::setDisconnectTimeout(double dur) {
  set_time(times_.disconnect, dur);
}
void Bond::setHeartbeatTimeout(double dur) {
  set_time(times_.heartbeat, dur);
}
void Bond::setHeartbeatPeriod(double dur) {
  set_time(times_.period, dur);
}
void Bond::setDeadPublishPeriod(double dur) {
  set_time(times_.dead_period, dur);
}

rclcpp::TimerBase::SharedPtr Bond::make_timer(double period_s, std::function<void()> callback) {
  const bool is_shared = !weak_from_this().expired();
  const auto call = [is_shared, weak = weak_from_this(), callback = std::move(callback)] {
    const auto self = weak.lock();
    if (self || !is_shared) callback();
  };
  return rclcpp::create_wall_timer(nanoseconds_of(period_s), call, callback_group_,
                                   node_base_.get(), node_timers_.get());
}

void Bond::connectTimerReset() {
  connect_timer_ = make_timer(times_.connect, [this] {
    cancel(connect_timer_);
    happen(Event::kConnectTimeout);
  });
}
void Bond::connectTimerCancel() {
  cancel(connect_timer_);
}

void Bond::disconnectTimerReset() {
  disconnect_timer_ = make_timer(times_.disconnect, [this] {
    cancel(disconnect_timer_);
    happen(Event::kDisconnectTimeout);
  });
}
void Bond::disconnectTimerCancel() {
  cancel(disconnect_timer_);
}

void Bond::heartbeatTimerReset() {
  if (ignores_silence_) return;
  if (heartbeat_timer_) {
    heartbeat_timer_->reset();
    return;
  }
  heartbeat_timer_ = make_timer(times_.heartbeat, [this] {
    cancel(heartbeat_timer_);
    happen(Event::kHeartbeatTimeout);
  });
}
void Bond::heartbeatTimerCancel() {
  cancel(heartbeat_timer_);
}

void Bond::publishingTimerReset() {
  publishing_timer_ = make_timer(times_.period, [this] { publish_due(); });
}
void Bond::publishingTimerCancel() {
  cancel(publishing_timer_);
}

void Bond::deadpublishingTimerReset() {
  dead_timer_ = make_timer(times_.dead_period, [this] { publish_due(); });
}
void Bond::deadpublishingTimerCancel() {
  cancel(dead_timer_);
}

void Bond::start() {
  subscribe();
  connectTimerReset();
  publishingTimerReset();
  started_ = true;
}

void Bond::setFormedCallback(EventCallback on_formed) {
  const std::lock_guard<std::mutex> lock(mutex_);
  on_formed_ = std::move(on_formed);
}

void Bond::setBrokenCallback(EventCallback on_broken) {
  const std::lock_guard<std::mutex> lock(mutex_);
  on_broken_ = std::move(on_broken);
}

bool Bond::wait_for(const std::function<bool(State)>& is_reached, rclcpp::Duration timeout) {
  rclcpp::Clock clock(RCL_STEADY_TIME);
  const bool has_end = timeout >= rclcpp::Duration(0ns);
  const rclcpp::Time end = clock.now() + timeout;
  while (rclcpp::ok() && (!has_end || clock.now() < end)) {
    rclcpp::sleep_for(kLook);
    if (is_reached(state())) return true;
  }
  return false;
}

bool Bond::waitUntilFormed(rclcpp::Duration timeout) {
  return wait_for([](State state) { return state != State::kWaitingForSister; }, timeout);
}

bool Bond::waitUntilBroken(rclcpp::Duration timeout) {
  return wait_for([](State state) { return state == State::kDead; }, timeout);
}

bool Bond::isBroken() {
  return state() == State::kDead;
}

Bond::State Bond::state() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return state_;
}

bool Bond::sister_left() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return sister_left_;
}

void Bond::breakBond() {
  if (!isBroken()) {
    happen(Event::kDie);
    publish_status(false);
  }
  run_callbacks();
}

void Bond::happen(Event event) {
  if (!started_) return;
  detail::BondStep step{};
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    step = detail::next_step(state_, event);
    state_ = step.state;
    sister_left_ = sister_left_ || step.sister_left;
    if (step.forms && on_formed_) due_callbacks_.push_back(on_formed_);
    if (step.breaks && on_broken_) due_callbacks_.push_back(on_broken_);
  }
  if (step.forms) connectTimerCancel();
  if (step.hears_beat) heartbeatTimerReset();
  if (step.starts_dying) {
    heartbeatTimerCancel();
    disconnectTimerReset();
    deadpublishingTimerReset();
  }
  if (step.breaks) {
    connectTimerCancel();
    heartbeatTimerCancel();
    disconnectTimerCancel();
  }
  run_callbacks();
}

void Bond::receive(const bond::msg::Status& status) {
  if (!started_ || status.id != id_ || status.instance_id == instance_id_) return;
  happen(status.active ? Event::kSisterAlive : Event::kSisterDead);
  if (!status.active && sister_left()) publish_status(false);
}

void Bond::publish_due() {
  switch (state()) {
    case State::kWaitingForSister:
    case State::kAlive:
      publish_status(true);
      break;
    case State::kAwaitSisterDeath:
      publish_status(false);
      break;
    case State::kDead:
      publishingTimerCancel();
      deadpublishingTimerCancel();
      break;
  }
}

void Bond::publish_status(bool active) {
  bond::msg::Status status;
  status.header.stamp = rclcpp::Clock(RCL_STEADY_TIME).now();
  status.id = id_;
  status.instance_id = instance_id_;
  status.active = active;
  status.heartbeat_timeout = static_cast<float>(times_.heartbeat);
  status.heartbeat_period = static_cast<float>(times_.period);
  publisher_->publish(status);
}

void Bond::run_callbacks() {
  std::vector<EventCallback> due;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    due.swap(due_callbacks_);
  }
  for (const EventCallback& callback : due) callback();
}

}  // namespace bond
