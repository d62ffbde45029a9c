// Goals at a server: states, status messages, cancelling, and results that grow old.
#include "rclcpp_action/server.hpp"

#include <cstdio>
#include <random>
#include <string>

#include "rclcpp/exceptions.hpp"
#include "rclcpp/node_interfaces/node_services.hpp"
#include "rclcpp/time.hpp"

rcl_action_server_options_t rcl_action_server_get_default_options() {
  rcl_action_server_options_t options{};
  options.goal_service_qos = rmw_qos_profile_services_default;
  options.cancel_service_qos = rmw_qos_profile_services_default;
  options.result_service_qos = rmw_qos_profile_services_default;
  options.feedback_topic_qos = rmw_qos_profile_default;
  options.status_topic_qos = rmw_qos_profile_default;
  options.status_topic_qos.depth = 1;
  options.status_topic_qos.durability = RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL;
  options.result_timeout.nanoseconds = RCL_S_TO_NS(10);
  return options;
}

namespace rclcpp_action {
namespace {

rclcpp::QoS qos_of(const rmw_qos_profile_t& profile) {
  return rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(profile), profile);
}

bool is_over(int8_t status) {
  return status == GoalStatus::STATUS_SUCCEEDED || status == GoalStatus::STATUS_CANCELED ||
         status == GoalStatus::STATUS_ABORTED;
}

}  // namespace

std::string to_string(const GoalUUID& goal_id) {
  std::string text;
  for (const uint8_t byte : goal_id) {
    char digits[4];
    std::snprintf(digits, sizeof(digits), "%x", byte);
    text += digits;
  }
  return text;
}

GoalUUID make_goal_id() {
  std::random_device device;
  GoalUUID id;
  for (uint8_t& byte : id) {
    byte = static_cast<uint8_t>(device());
  }
  id[6] = static_cast<uint8_t>((id[6] & 0x0f) | 0x40);
  id[8] = static_cast<uint8_t>((id[8] & 0x3f) | 0x80);
  return id;
}

namespace {

/// As rcl writes them.
const char* status_name(int8_t status) {
  switch (status) {
    case GoalStatus::STATUS_ACCEPTED:
      return "ACCEPTED";
    case GoalStatus::STATUS_EXECUTING:
      return "EXECUTING";
    case GoalStatus::STATUS_CANCELING:
      return "CANCELING";
    case GoalStatus::STATUS_SUCCEEDED:
      return "SUCCEEDED";
    case GoalStatus::STATUS_CANCELED:
      return "CANCELED";
    case GoalStatus::STATUS_ABORTED:
      return "ABORTED";
    default:
      return "UNKNOWN";
  }
}

}  // namespace

const char* GoalState::event_name(Event event) {
  switch (event) {
    case Event::execute:
      return "EXECUTE";
    case Event::cancel_goal:
      return "CANCEL_GOAL";
    case Event::succeed:
      return "SUCCEED";
    case Event::abort:
      return "ABORT";
    case Event::canceled:
      return "CANCELED";
  }
  return "UNKNOWN";
}

int8_t GoalState::status() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return status_;
}

bool GoalState::is_active() const {
  return !is_over(status());
}

bool GoalState::is_cancelable() const {
  return next(status(), Event::cancel_goal) != 0;
}

int8_t GoalState::next(int8_t status, Event event) {
  const bool executing = status == GoalStatus::STATUS_EXECUTING;
  const bool canceling = status == GoalStatus::STATUS_CANCELING;
  switch (event) {
    case Event::execute:
      return status == GoalStatus::STATUS_ACCEPTED ? GoalStatus::STATUS_EXECUTING : 0;
    case Event::cancel_goal:
      return status == GoalStatus::STATUS_ACCEPTED || executing ? GoalStatus::STATUS_CANCELING : 0;
    case Event::succeed:
      return executing || canceling ? GoalStatus::STATUS_SUCCEEDED : 0;
    case Event::abort:
      return executing || canceling ? GoalStatus::STATUS_ABORTED : 0;
    case Event::canceled:
      return canceling ? GoalStatus::STATUS_CANCELED : 0;
  }
  return 0;
}

void GoalState::change(Event event) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const int8_t changed = next(status_, event);
  if (changed == 0) {
    const std::string text = std::string("goal_handle attempted invalid transition from state ") +
                             status_name(status_) + " with event " + event_name(event);
    rcutils_set_error_state(text.c_str(), __FILE__, __LINE__);
    rclcpp::exceptions::throw_from_rcl_error(RCL_RET_ERROR);
  }
  status_ = changed;
}

void GoalState::execute() {
  change(Event::execute);
}
void GoalState::cancel_goal() {
  change(Event::cancel_goal);
}
void GoalState::succeed() {
  change(Event::succeed);
}
void GoalState::abort() {
  change(Event::abort);
}
void GoalState::canceled() {
  change(Event::canceled);
}

bool GoalState::try_canceling() noexcept {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (is_over(status_)) {
    return false;
  }
  status_ = GoalStatus::STATUS_CANCELING;
  return true;
}

ServerBase::ServerBase(rclcpp::node_interfaces::NodeBaseInterface* node_base,
                       rclcpp::Clock::SharedPtr clock, const std::string& name,
                       const rcl_action_server_options_t& options,
                       const rclcpp::CallbackGroup::SharedPtr& group)
    : node_base_(node_base),
      clock_(std::move(clock)),
      name_(name),
      options_(options),
      group_(group),
      status_publisher_(std::make_shared<rclcpp::Publisher<action_msgs::msg::GoalStatusArray>>(
          node_base, name + "/_action/status", qos_of(options.status_topic_qos),
          rclcpp::PublisherOptions())) {
  rclcpp::AnyServiceCallback<CancelGoal> callback;
  callback.set(
      [this](std::shared_ptr<CancelGoal::Request> request,
             std::shared_ptr<CancelGoal::Response> response) { cancel(*request, *response); });
  add_service(std::make_shared<rclcpp::Service<CancelGoal>>(
      node_base, name + "/_action/cancel_goal", std::move(callback),
      qos_of(options.cancel_service_qos)));
}

ServerBase::~ServerBase() = default;

void ServerBase::add_service(const rclcpp::ServiceBase::SharedPtr& service) {
  rclcpp::node_interfaces::NodeServices(node_base_).add_service(service, group_);
  services_.push_back(service);
}

std::shared_ptr<GoalState> ServerBase::add_goal(const GoalUUID& uuid,
                                                builtin_interfaces::msg::Time stamp) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  drop_old_results();
  GoalRecord& record = goals_[uuid];
  record.stamp = stamp;
  record.state = std::make_shared<GoalState>();
  return record.state;
}

bool ServerBase::has_goal(const GoalUUID& uuid) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  return goals_.count(uuid) != 0;
}

void ServerBase::note_end(const GoalUUID& uuid) {
  {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    const auto found = goals_.find(uuid);
    if (found != goals_.end()) {
      found->second.ended_ns = clock_->now().nanoseconds();
    }
  }
  publish_status();
}

void ServerBase::drop_old_results() {
  const int64_t now = clock_->now().nanoseconds();
  const int64_t kept_ns = options_.result_timeout.nanoseconds;
  for (auto it = goals_.begin(); it != goals_.end();) {
    const bool old =
        it->second.ended_ns != 0 && kept_ns >= 0 && now - it->second.ended_ns > kept_ns;
    if (old) {
      forget(it->first);
      it = goals_.erase(it);
    } else {
      ++it;
    }
  }
}

void ServerBase::publish_status() {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  action_msgs::msg::GoalStatusArray message;
  for (const auto& [uuid, record] : goals_) {
    action_msgs::msg::GoalStatus status;
    status.goal_info.goal_id.uuid = uuid;
    status.goal_info.stamp = record.stamp;
    status.status = record.state->status();
    message.status_list.push_back(status);
  }
  status_publisher_->publish(message);
}

// An id names one goal, a stamp all that were accepted until then, both the union, none all. Those
// that can be cancelled are asked; that there are none is an error only to who wants one goal.
void ServerBase::cancel(const CancelGoal::Request& request, CancelGoal::Response& response) {
  const GoalUUID wanted = request.goal_info.goal_id.uuid;
  const bool any_id = wanted == GoalUUID{};
  const int64_t until = rclcpp::Time(request.goal_info.stamp).nanoseconds();
  std::vector<std::pair<GoalUUID, GoalRecord>> asked;
  bool known = false;
  {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    for (const auto& [uuid, record] : goals_) {
      const bool by_id = !any_id && uuid == wanted;
      const bool by_time = (any_id && until == 0) ||
                           (until != 0 && rclcpp::Time(record.stamp).nanoseconds() <= until);
      known = known || by_id;
      if ((by_id || by_time) && record.state->is_cancelable()) {
        asked.emplace_back(uuid, record);
      }
    }
  }
  for (const auto& [uuid, record] : asked) {
    if (ask_to_cancel(uuid) != CancelResponse::ACCEPT || !record.state->is_cancelable()) {
      continue;
    }
    record.state->cancel_goal();
    action_msgs::msg::GoalInfo info;
    info.goal_id.uuid = uuid;
    info.stamp = record.stamp;
    response.goals_canceling.push_back(info);
  }
  if (!response.goals_canceling.empty()) {
    response.return_code = CancelGoal::Response::ERROR_NONE;
    publish_status();
  } else if (!asked.empty()) {
    response.return_code = CancelGoal::Response::ERROR_REJECTED;
  } else if (any_id || until != 0) {
    response.return_code = CancelGoal::Response::ERROR_NONE;
  } else {
    response.return_code = known ? CancelGoal::Response::ERROR_GOAL_TERMINATED
                                 : CancelGoal::Response::ERROR_UNKNOWN_GOAL_ID;
  }
}

}  // namespace rclcpp_action
