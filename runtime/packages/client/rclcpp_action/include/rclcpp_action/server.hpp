// An action server: three services, two topics, and the goals.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "action_msgs/msg/goal_status_array.hpp"
#include "action_msgs/srv/cancel_goal.hpp"
#include "rclcpp/clock.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp_action/server_goal_handle.hpp"
#include "rclcpp_action/types.hpp"

/// Profiles and the time for which results are kept after a goal ended.
struct rcl_action_server_options_t {
  rmw_qos_profile_t goal_service_qos;
  rmw_qos_profile_t cancel_service_qos;
  rmw_qos_profile_t result_service_qos;
  rmw_qos_profile_t feedback_topic_qos;
  rmw_qos_profile_t status_topic_qos;
  rcl_duration_t result_timeout;
};
rcl_action_server_options_t rcl_action_server_get_default_options();

namespace rclcpp_action {

/// The part that does not depend on the action's type: goals' states, status, cancelling.
class ServerBase {
 public:
  using CancelGoal = action_msgs::srv::CancelGoal;
  virtual ~ServerBase();

 protected:
  ServerBase(rclcpp::node_interfaces::NodeBaseInterface* node_base, rclcpp::Clock::SharedPtr clock,
             const std::string& name, const rcl_action_server_options_t& options,
             const rclcpp::CallbackGroup::SharedPtr& group);

  /// Whether the user lets this goal be cancelled.
  virtual CancelResponse ask_to_cancel(const GoalUUID& uuid) = 0;
  /// Drops the stored result of a goal.
  virtual void forget(const GoalUUID& uuid) = 0;

  std::shared_ptr<GoalState> add_goal(const GoalUUID& uuid, builtin_interfaces::msg::Time stamp);
  bool has_goal(const GoalUUID& uuid);
  /// Notes when a goal ended, publishes the new states, drops results that are too old.
  void note_end(const GoalUUID& uuid);
  void publish_status();
  void add_service(const rclcpp::ServiceBase::SharedPtr& service);

  rclcpp::node_interfaces::NodeBaseInterface* node_base_;
  rclcpp::Clock::SharedPtr clock_;
  const std::string name_;
  const rcl_action_server_options_t options_;
  rclcpp::CallbackGroup::SharedPtr group_;
  std::recursive_mutex mutex_;

 private:
  struct GoalRecord {
    builtin_interfaces::msg::Time stamp;
    std::shared_ptr<GoalState> state;
    int64_t ended_ns = 0;
  };
  void cancel(const CancelGoal::Request& request, CancelGoal::Response& response);
  void drop_old_results();

  std::map<GoalUUID, GoalRecord> goals_;
  rclcpp::Publisher<action_msgs::msg::GoalStatusArray>::SharedPtr status_publisher_;
  std::vector<rclcpp::ServiceBase::SharedPtr> services_;
};

template <typename ActionT>
class Server : public ServerBase, public std::enable_shared_from_this<Server<ActionT>> {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(Server)

  using GoalHandle = ServerGoalHandle<ActionT>;
  using GoalCallback =
      std::function<GoalResponse(const GoalUUID&, std::shared_ptr<const typename ActionT::Goal>)>;
  using CancelCallback = std::function<CancelResponse(std::shared_ptr<GoalHandle>)>;
  using AcceptedCallback = std::function<void(std::shared_ptr<GoalHandle>)>;

  Server(rclcpp::node_interfaces::NodeBaseInterface* node_base, rclcpp::Clock::SharedPtr clock,
         const std::string& name, const rcl_action_server_options_t& options,
         GoalCallback handle_goal, CancelCallback handle_cancel, AcceptedCallback handle_accepted,
         const rclcpp::CallbackGroup::SharedPtr& group)
      : ServerBase(node_base, std::move(clock), name, options, group),
        handle_goal_(std::move(handle_goal)),
        handle_cancel_(std::move(handle_cancel)),
        handle_accepted_(std::move(handle_accepted)),
        feedback_publisher_(std::make_shared<rclcpp::Publisher<FeedbackMessage>>(
            node_base, name + "/_action/feedback",
            rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(options.feedback_topic_qos),
                        options.feedback_topic_qos),
            rclcpp::PublisherOptions())) {}

  ~Server() override = default;

  /// Opens the services. Called once, by create_server, when the server is held by a pointer.
  void start() {
    std::weak_ptr<Server> weak = this->weak_from_this();
    rclcpp::AnyServiceCallback<SendGoal> goal;
    goal.set([weak](const std::shared_ptr<rclcpp::Service<SendGoal>>& service,
                    const std::shared_ptr<rmw_request_id_t>& header,
                    const std::shared_ptr<typename SendGoal::Request>& request) {
      if (const auto self = weak.lock()) {
        self->on_goal(*service, *header, request);
      }
    });
    add_service(std::make_shared<rclcpp::Service<SendGoal>>(
        node_base_, name_ + "/_action/send_goal", std::move(goal),
        rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(options_.goal_service_qos),
                    options_.goal_service_qos)));
    rclcpp::AnyServiceCallback<GetResult> result;
    result.set([weak](const std::shared_ptr<rclcpp::Service<GetResult>>& service,
                      const std::shared_ptr<rmw_request_id_t>& header,
                      const std::shared_ptr<typename GetResult::Request>& request) {
      if (const auto self = weak.lock()) {
        self->on_result_request(*service, *header, request->goal_id.uuid);
      }
    });
    result_service_ = std::make_shared<rclcpp::Service<GetResult>>(
        node_base_, name_ + "/_action/get_result", std::move(result),
        rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(options_.result_service_qos),
                    options_.result_service_qos));
    add_service(result_service_);
  }

 protected:
  using SendGoal = typename ActionT::Impl::SendGoalService;
  using GetResult = typename ActionT::Impl::GetResultService;
  using FeedbackMessage = typename ActionT::Impl::FeedbackMessage;
  using ResultResponse = typename GetResult::Response;

  CancelResponse ask_to_cancel(const GoalUUID& uuid) override {
    std::shared_ptr<GoalHandle> handle;
    {
      const std::lock_guard<std::recursive_mutex> lock(mutex_);
      const auto found = handles_.find(uuid);
      handle = found == handles_.end() ? nullptr : found->second.lock();
    }
    return handle ? handle_cancel_(handle) : CancelResponse::REJECT;
  }

  void forget(const GoalUUID& uuid) override {
    results_.erase(uuid);
    handles_.erase(uuid);
  }

 private:
  RCLCPP_DISABLE_COPY(Server)

  void on_goal(rclcpp::Service<SendGoal>& service, rmw_request_id_t& header,
               const std::shared_ptr<typename SendGoal::Request>& request) {
    const GoalUUID uuid = request->goal_id.uuid;
    // The goal shares the request's memory.
    std::shared_ptr<const typename ActionT::Goal> goal(request, &request->goal);
    typename SendGoal::Response response;
    response.stamp = clock_->now();
    const GoalResponse decision = has_goal(uuid) ? GoalResponse::REJECT : handle_goal_(uuid, goal);
    response.accepted = decision != GoalResponse::REJECT;
    if (!response.accepted) {
      service.send_response(header, response);
      return;
    }
    const auto state = add_goal(uuid, response.stamp);
    service.send_response(header, response);
    if (decision == GoalResponse::ACCEPT_AND_EXECUTE) {
      state->execute();
    }
    publish_status();
    handle_accepted_(make_handle(uuid, state, goal));
  }

  std::shared_ptr<GoalHandle> make_handle(
      const GoalUUID& uuid, const std::shared_ptr<GoalState>& state,
      const std::shared_ptr<const typename ActionT::Goal>& goal) {
    std::weak_ptr<Server> weak = this->weak_from_this();
    std::shared_ptr<GoalHandle> handle(new GoalHandle(
        state, uuid, goal,
        [weak](const GoalUUID& id, std::shared_ptr<ResultResponse> result) {
          if (const auto self = weak.lock()) {
            self->on_end(id, std::move(result));
          }
        },
        [weak](const GoalUUID&) {
          if (const auto self = weak.lock()) {
            self->publish_status();
          }
        },
        [weak](const std::shared_ptr<FeedbackMessage>& feedback) {
          if (const auto self = weak.lock()) {
            self->feedback_publisher_->publish(*feedback);
          }
        }));
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    handles_[uuid] = handle;
    return handle;
  }

  void on_end(const GoalUUID& uuid, std::shared_ptr<ResultResponse> result) {
    std::vector<rmw_request_id_t> waiting;
    {
      const std::lock_guard<std::recursive_mutex> lock(mutex_);
      results_[uuid] = result;
      waiting = std::move(waiting_[uuid]);
      waiting_.erase(uuid);
    }
    note_end(uuid);
    for (rmw_request_id_t& header : waiting) {
      result_service_->send_response(header, *result);
    }
  }

  void on_result_request(rclcpp::Service<GetResult>& service, rmw_request_id_t& header,
                         const GoalUUID& uuid) {
    std::shared_ptr<ResultResponse> result;
    {
      const std::lock_guard<std::recursive_mutex> lock(mutex_);
      const auto found = results_.find(uuid);
      if (found != results_.end()) {
        result = found->second;
      } else if (has_goal(uuid)) {
        waiting_[uuid].push_back(header);
        return;
      } else {
        result = std::make_shared<ResultResponse>();
        result->status = GoalStatus::STATUS_UNKNOWN;
      }
    }
    service.send_response(header, *result);
  }

  GoalCallback handle_goal_;
  CancelCallback handle_cancel_;
  AcceptedCallback handle_accepted_;
  typename rclcpp::Publisher<FeedbackMessage>::SharedPtr feedback_publisher_;
  typename rclcpp::Service<GetResult>::SharedPtr result_service_;
  std::map<GoalUUID, std::weak_ptr<GoalHandle>> handles_;
  std::map<GoalUUID, std::shared_ptr<ResultResponse>> results_;
  std::map<GoalUUID, std::vector<rmw_request_id_t>> waiting_;
};

}  // namespace rclcpp_action
