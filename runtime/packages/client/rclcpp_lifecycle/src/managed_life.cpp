// Takes a managed node from state to state.
#include "managed_life.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include "lifecycle_msgs/msg/state.hpp"
#include "rclcpp/logging.hpp"

namespace rclcpp_lifecycle {
namespace {

using Lock = std::lock_guard<std::recursive_mutex>;

const char* label_of(ManagedLife::CallbackReturn result) {
  switch (result) {
    case ManagedLife::CallbackReturn::SUCCESS:
      return kSuccessLabel;
    case ManagedLife::CallbackReturn::FAILURE:
      return kFailureLabel;
    case ManagedLife::CallbackReturn::ERROR:
      break;
  }
  return kErrorLabel;  // also what a callback returns that is none of the three
}

lifecycle_msgs::msg::State to_message(const State& state) {
  lifecycle_msgs::msg::State message;
  message.id = state.id();
  message.label = state.label();
  return message;
}

template <typename RowsT>
void list(const RowsT& rows, lifecycle_msgs::srv::GetAvailableTransitions::Response& response) {
  for (const TransitionRow& row : rows) {
    auto& one = response.available_transitions.emplace_back();
    one.transition.id = row.id;
    one.transition.label = row.label;
    one.start_state = to_message(state_of(row.start));
    one.goal_state = to_message(state_of(row.goal));
  }
}

void warn_of_missing(uint8_t id, const State& state) {
  RCLCPP_WARN(rclcpp::get_logger("rcl_lifecycle"),
              "No transition matching %d found for current state %s", id, state.label().c_str());
}

void warn_of_missing(const std::string& label, const State& state) {
  RCLCPP_WARN(rclcpp::get_logger("rcl_lifecycle"),
              "No transition matching %s found for current state %s", label.c_str(),
              state.label().c_str());
}

}  // namespace

ManagedLife::ManagedLife(rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base,
                         rclcpp::node_interfaces::NodeServicesInterface::SharedPtr node_services,
                         rclcpp::Logger logger, bool with_services)
    : node_base_(std::move(node_base)),
      node_services_(std::move(node_services)),
      logger_(std::move(logger)),
      events_(node_base_.get(), "~/transition_event", rclcpp::QoS(10), rclcpp::PublisherOptions()),
      current_(state_of(lifecycle_msgs::msg::State::PRIMARY_STATE_UNCONFIGURED)) {
  if (with_services) {
    add_services();
  }
}

void ManagedLife::add_services() {
  add_service<ChangeState>("~/change_state", [this](const auto& request, auto& response) {
    answer_change_state(request, response);
  });
  add_service<GetState>("~/get_state", [this](const auto&, auto& response) {
    const Lock lock(mutex_);
    response.current_state = to_message(current_);
  });
  add_service<GetAvailableStates>("~/get_available_states", [](const auto&, auto& response) {
    for (const StateRow& row : kStates) {
      response.available_states.push_back(to_message(state_of(row.id)));
    }
  });
  add_service<GetAvailableTransitions>(
      "~/get_available_transitions",
      [this](const auto&, auto& response) { list(available_transitions(), response); });
  add_service<GetAvailableTransitions>(
      "~/get_transition_graph", [](const auto&, auto& response) { list(kTransitions, response); });
}

template <typename ServiceT, typename CallbackT>
void ManagedLife::add_service(const char* name, CallbackT callback) {
  rclcpp::AnyServiceCallback<ServiceT> any;
  any.set([callback](const std::shared_ptr<typename ServiceT::Request> request,
                     std::shared_ptr<typename ServiceT::Response> response) {
    callback(*request, *response);
  });
  auto service = std::make_shared<rclcpp::Service<ServiceT>>(node_base_.get(), name, std::move(any),
                                                             rclcpp::ServicesQoS());
  node_services_->add_service(service, nullptr);
  services_.push_back(std::move(service));
}

void ManagedLife::answer_change_state(const ChangeState::Request& request,
                                      ChangeState::Response& response) {
  uint8_t id = request.transition.id;
  // A label goes before the number, which is 0 when it was not given.
  if (!request.transition.label.empty()) {
    const Lock lock(mutex_);
    const TransitionRow* row = find_here(request.transition.label);
    if (row == nullptr) {
      response.success = false;
      return;
    }
    id = row->id;
  }
  CallbackReturn result = CallbackReturn::ERROR;
  change_state(id, result);
  response.success = result == CallbackReturn::SUCCESS;
}

template <typename KeyT>
const TransitionRow* ManagedLife::find_here(const KeyT& id_or_label) const {
  const TransitionRow* row = find_transition(current_.id(), id_or_label);
  if (row == nullptr) {
    warn_of_missing(id_or_label, current_);
  }
  return row;
}

std::vector<TransitionRow> ManagedLife::available_transitions() const {
  const Lock lock(mutex_);
  std::vector<TransitionRow> rows;
  std::copy_if(kTransitions.begin(), kTransitions.end(), std::back_inserter(rows),
               [this](const TransitionRow& row) { return row.start == current_.id(); });
  return rows;
}

void ManagedLife::set_callback(uint8_t transition_state, Callback callback) {
  callbacks_[transition_state] = std::move(callback);
}

void ManagedLife::change_state(const char* label, CallbackReturn& result) {
  const TransitionRow* row = nullptr;
  {
    const Lock lock(mutex_);
    row = find_here(std::string(label));
  }
  if (row != nullptr) {
    change_state(row->id, result);
  }
}

void ManagedLife::change_state(uint8_t transition_id, CallbackReturn& result) {
  State initial;
  {
    const Lock lock(mutex_);
    const TransitionRow* row = find_here(transition_id);
    if (row == nullptr) {
      RCLCPP_ERROR(logger_,
                   "Unable to start transition %u from current state %s: "
                   "Transition is not registered.",
                   static_cast<unsigned>(transition_id), current_.label().c_str());
      return;
    }
    initial = current_;
    step(*row);
  }
  if (pass_through(transition_id, initial, result) && result == CallbackReturn::ERROR) {
    RCLCPP_WARN(logger_, "Error occurred while doing error handling.");
    CallbackReturn handled = CallbackReturn::ERROR;
    pass_through(transition_id, initial, handled);
  }
}

void ManagedLife::step(const TransitionRow& row) {
  TransitionEvent event;
  event.start_state = to_message(current_);
  current_ = state_of(row.goal);
  event.goal_state = to_message(current_);
  events_.publish(event);
}

bool ManagedLife::pass_through(uint8_t transition_id, const State& initial,
                               CallbackReturn& result) {
  result = call(initial);
  const Lock lock(mutex_);
  const TransitionRow* row = find_here(std::string(label_of(result)));
  if (row == nullptr) {
    RCLCPP_ERROR(logger_,
                 "Failed to finish transition %u. Current state is now: %s "
                 "(Transition is not registered.)",
                 static_cast<unsigned>(transition_id), current_.label().c_str());
    return false;
  }
  step(*row);
  return true;
}

ManagedLife::CallbackReturn ManagedLife::call(const State& initial) const {
  const auto found = callbacks_.find(current_.id());
  if (found == callbacks_.end()) {
    return CallbackReturn::SUCCESS;
  }
  const Callback callback = found->second;
  try {
    return callback(State(initial));
  } catch (const std::exception& error) {
    RCLCPP_ERROR(logger_, "Caught exception in callback for transition %d", found->first);
    RCLCPP_ERROR(logger_, "Original error: %s", error.what());
    return CallbackReturn::ERROR;
  }
}

void ManagedLife::add_managed_entity(std::weak_ptr<ManagedEntityInterface> entity) {
  entities_.push_back(std::move(entity));
}

void ManagedLife::activate_entities() const {
  for (const auto& weak : entities_) {
    if (const auto entity = weak.lock()) {
      entity->on_activate();
    }
  }
}

void ManagedLife::deactivate_entities() const {
  for (const auto& weak : entities_) {
    if (const auto entity = weak.lock()) {
      entity->on_deactivate();
    }
  }
}

}  // namespace rclcpp_lifecycle
