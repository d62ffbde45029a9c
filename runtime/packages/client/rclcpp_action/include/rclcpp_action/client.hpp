// An action client: three service clients and two subscriptions.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "action_msgs/msg/goal_status_array.hpp"
#include "action_msgs/srv/cancel_goal.hpp"
#include "rclcpp/client.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/subscription.hpp"
#include "rclcpp/time.hpp"
#include "rclcpp_action/client_goal_handle.hpp"
#include "rclcpp_action/exceptions.hpp"
#include "rclcpp_action/types.hpp"

struct rcl_action_client_options_t {
  rmw_qos_profile_t goal_service_qos;
  rmw_qos_profile_t result_service_qos;
  rmw_qos_profile_t cancel_service_qos;
  rmw_qos_profile_t feedback_topic_qos;
  rmw_qos_profile_t status_topic_qos;
};
rcl_action_client_options_t rcl_action_client_get_default_options();

namespace rclcpp_action {

/// The part that does not depend on the action's type: its service clients and subscriptions.
class ClientBase {
 public:
  virtual ~ClientBase();
  bool action_server_is_ready() const;
  /// False after the timeout or on shutdown. Negative: waits for ever.
  template <typename RepT = int64_t, typename RatioT = std::milli>
  bool wait_for_action_server(
      std::chrono::duration<RepT, RatioT> timeout = std::chrono::duration<RepT, RatioT>(-1)) {
    return wait_for_action_server_nanoseconds(
        std::chrono::duration_cast<std::chrono::nanoseconds>(timeout));
  }

 protected:
  ClientBase(rclcpp::node_interfaces::NodeBaseInterface* node_base,
             rclcpp::CallbackGroup::SharedPtr group);
  bool wait_for_action_server_nanoseconds(std::chrono::nanoseconds timeout);
  void add_client(const rclcpp::ClientBase::SharedPtr& client);
  void add_subscription(const rclcpp::SubscriptionBase::SharedPtr& subscription);
  static rclcpp::QoS qos_of(const rmw_qos_profile_t& profile);

 private:
  rclcpp::node_interfaces::NodeBaseInterface* node_base_;
  rclcpp::CallbackGroup::SharedPtr group_;
  std::vector<rclcpp::ClientBase::SharedPtr> clients_;
  std::vector<rclcpp::SubscriptionBase::SharedPtr> subscriptions_;
};

/// Can be made from callables that take a goal handle, and from those that take a future of it, as
/// in ROS 2 Foxy.
template <typename HandleT>
class GoalResponseFunction : public std::function<void(HandleT)> {
  using Base = std::function<void(HandleT)>;
  using Future = std::shared_future<HandleT>;

 public:
  GoalResponseFunction(std::nullptr_t = nullptr) {}
  template <typename FunctionT,
            std::enable_if_t<std::disjunction_v<std::is_invocable<FunctionT&, HandleT>,
                                                std::is_invocable<FunctionT&, Future>>,
                             int> = 0>
  GoalResponseFunction(FunctionT function) : Base(of_handle(std::move(function))) {}

 private:
  template <typename FunctionT>
  static Base of_handle(FunctionT function) {
    if constexpr (std::is_invocable_v<FunctionT&, HandleT>) {
      return function;
    } else {
      return [function = std::move(function)](HandleT handle) mutable {
        std::promise<HandleT> promise;
        promise.set_value(std::move(handle));
        function(Future(promise.get_future()));
      };
    }
  }
};

template <typename ActionT>
class Client : public ClientBase, public std::enable_shared_from_this<Client<ActionT>> {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(Client)

  using Goal = typename ActionT::Goal;
  using Feedback = typename ActionT::Feedback;
  using GoalHandle = ClientGoalHandle<ActionT>;
  using WrappedResult = typename GoalHandle::WrappedResult;
  using GoalResponseCallback = GoalResponseFunction<typename GoalHandle::SharedPtr>;
  using FeedbackCallback = typename GoalHandle::FeedbackCallback;
  using ResultCallback = typename GoalHandle::ResultCallback;
  using CancelGoal = action_msgs::srv::CancelGoal;
  using CancelRequest = CancelGoal::Request;
  using CancelResponse = CancelGoal::Response;
  using CancelCallback = std::function<void(CancelResponse::SharedPtr)>;

  struct SendGoalOptions {
    /// Gets null when the goal was rejected.
    GoalResponseCallback goal_response_callback;
    FeedbackCallback feedback_callback;
    ResultCallback result_callback;
  };

  Client(rclcpp::node_interfaces::NodeBaseInterface* node_base, const std::string& name,
         const rcl_action_client_options_t& options, rclcpp::CallbackGroup::SharedPtr group)
      : ClientBase(node_base, std::move(group)),
        goal_client_(std::make_shared<rclcpp::Client<SendGoal>>(
            node_base, name + "/_action/send_goal", qos_of(options.goal_service_qos))),
        result_client_(std::make_shared<rclcpp::Client<GetResult>>(
            node_base, name + "/_action/get_result", qos_of(options.result_service_qos))),
        cancel_client_(std::make_shared<rclcpp::Client<CancelGoal>>(
            node_base, name + "/_action/cancel_goal", qos_of(options.cancel_service_qos))) {
    add_client(goal_client_);
    add_client(result_client_);
    add_client(cancel_client_);
    rclcpp::AnySubscriptionCallback<FeedbackMessage> on_feedback;
    on_feedback.set([this](std::shared_ptr<const FeedbackMessage> message) {
      if (const auto handle = find(message->goal_id.uuid)) {
        handle->call_feedback_callback(
            handle, std::shared_ptr<const Feedback>(message, &message->feedback));
      }
    });
    feedback_ = std::make_shared<rclcpp::Subscription<FeedbackMessage>>(
        node_base, name + "/_action/feedback", qos_of(options.feedback_topic_qos),
        std::move(on_feedback), rclcpp::SubscriptionOptions());
    add_subscription(feedback_);
    rclcpp::AnySubscriptionCallback<action_msgs::msg::GoalStatusArray> on_status;
    on_status.set([this](const action_msgs::msg::GoalStatusArray& message) {
      for (const auto& status : message.status_list) {
        if (const auto handle = find(status.goal_info.goal_id.uuid)) {
          handle->set_status(status.status);
        }
      }
    });
    status_ = std::make_shared<rclcpp::Subscription<action_msgs::msg::GoalStatusArray>>(
        node_base, name + "/_action/status", qos_of(options.status_topic_qos), std::move(on_status),
        rclcpp::SubscriptionOptions());
    add_subscription(status_);
  }

  ~Client() override {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    for (const auto& [uuid, weak] : handles_) {
      if (const auto handle = weak.lock()) {
        handle->invalidate(exceptions::UnawareGoalHandleError());
      }
    }
  }

  /// The future gives null when the goal is rejected.
  std::shared_future<typename GoalHandle::SharedPtr> async_send_goal(
      const Goal& goal, const SendGoalOptions& options = SendGoalOptions()) {
    auto promise = std::make_shared<std::promise<typename GoalHandle::SharedPtr>>();
    std::shared_future<typename GoalHandle::SharedPtr> future(promise->get_future());
    auto request = std::make_shared<typename SendGoal::Request>();
    request->goal_id.uuid = make_goal_id();
    request->goal = goal;
    forget_dropped();
    goal_client_->async_send_request(
        request,
        [this, request, options, promise](typename rclcpp::Client<SendGoal>::SharedFuture answer) {
          on_goal_response(*request, *answer.get(), options, *promise);
        });
    return future;
  }

  /// Throws UnknownGoalHandleError for a goal of another client.
  std::shared_future<WrappedResult> async_get_result(typename GoalHandle::SharedPtr goal_handle,
                                                     ResultCallback result_callback = nullptr) {
    require_known(*goal_handle);
    if (result_callback) {
      goal_handle->set_result_callback(std::move(result_callback));
    }
    ask_for_result(goal_handle);
    return goal_handle->result_future_;
  }

  std::shared_future<CancelResponse::SharedPtr> async_cancel_goal(
      typename GoalHandle::SharedPtr goal_handle, CancelCallback cancel_callback = nullptr) {
    require_known(*goal_handle);
    auto request = std::make_shared<CancelRequest>();
    request->goal_info.goal_id.uuid = goal_handle->get_goal_id();
    return cancel(std::move(request), std::move(cancel_callback));
  }
  std::shared_future<CancelResponse::SharedPtr> async_cancel_all_goals(
      CancelCallback cancel_callback = nullptr) {
    return cancel(std::make_shared<CancelRequest>(), std::move(cancel_callback));
  }
  std::shared_future<CancelResponse::SharedPtr> async_cancel_goals_before(
      const rclcpp::Time& stamp, CancelCallback cancel_callback = nullptr) {
    auto request = std::make_shared<CancelRequest>();
    request->goal_info.stamp = stamp;
    return cancel(std::move(request), std::move(cancel_callback));
  }

  void stop_callbacks(typename GoalHandle::SharedPtr goal_handle) {
    goal_handle->set_callbacks(nullptr, nullptr);
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    handles_.erase(goal_handle->get_goal_id());
  }
  void stop_callbacks(const GoalUUID& goal_id) {
    if (auto handle = find(goal_id)) {
      stop_callbacks(std::move(handle));
    }
  }

 private:
  RCLCPP_DISABLE_COPY(Client)
  using SendGoal = typename ActionT::Impl::SendGoalService;
  using GetResult = typename ActionT::Impl::GetResultService;
  using FeedbackMessage = typename ActionT::Impl::FeedbackMessage;

  typename GoalHandle::SharedPtr find(const GoalUUID& uuid) {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    const auto found = handles_.find(uuid);
    return found == handles_.end() ? nullptr : found->second.lock();
  }

  void require_known(const GoalHandle& handle) {
    if (!find(handle.get_goal_id())) {
      throw exceptions::UnknownGoalHandleError();
    }
  }

  void forget_dropped() {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    for (auto it = handles_.begin(); it != handles_.end();) {
      it = it->second.expired() ? handles_.erase(it) : std::next(it);
    }
  }

  void on_goal_response(const typename SendGoal::Request& request,
                        const typename SendGoal::Response& response, const SendGoalOptions& options,
                        std::promise<typename GoalHandle::SharedPtr>& promise) {
    typename GoalHandle::SharedPtr handle;
    if (response.accepted) {
      GoalInfo info;
      info.goal_id.uuid = request.goal_id.uuid;
      info.stamp = response.stamp;
      handle.reset(new GoalHandle(info, options.feedback_callback, options.result_callback));
      const std::lock_guard<std::recursive_mutex> lock(mutex_);
      handles_[info.goal_id.uuid] = handle;
    }
    promise.set_value(handle);
    if (options.goal_response_callback) {
      options.goal_response_callback(handle);
    }
    if (handle && options.result_callback) {
      ask_for_result(handle);
    }
  }

  void ask_for_result(const typename GoalHandle::SharedPtr& handle) {
    if (handle->set_result_awareness(true)) {
      return;
    }
    auto request = std::make_shared<typename GetResult::Request>();
    request->goal_id.uuid = handle->get_goal_id();
    // The request holds the handle: the result reaches it even if the caller let it go.
    result_client_->async_send_request(
        request, [this, handle](typename rclcpp::Client<GetResult>::SharedFuture answer) {
          const auto response = answer.get();
          WrappedResult result;
          result.goal_id = handle->get_goal_id();
          result.code = static_cast<ResultCode>(response->status);
          result.result = std::make_shared<typename ActionT::Result>(response->result);
          handle->set_result(result);
          const std::lock_guard<std::recursive_mutex> lock(mutex_);
          handles_.erase(handle->get_goal_id());
        });
  }

  std::shared_future<CancelResponse::SharedPtr> cancel(std::shared_ptr<CancelRequest> request,
                                                       CancelCallback callback) {
    auto promise = std::make_shared<std::promise<CancelResponse::SharedPtr>>();
    std::shared_future<CancelResponse::SharedPtr> future(promise->get_future());
    cancel_client_->async_send_request(
        std::move(request),
        [promise, callback = std::move(callback)](rclcpp::Client<CancelGoal>::SharedFuture answer) {
          promise->set_value(answer.get());
          if (callback) {
            callback(answer.get());
          }
        });
    return future;
  }

  typename rclcpp::Client<SendGoal>::SharedPtr goal_client_;
  typename rclcpp::Client<GetResult>::SharedPtr result_client_;
  rclcpp::Client<CancelGoal>::SharedPtr cancel_client_;
  typename rclcpp::Subscription<FeedbackMessage>::SharedPtr feedback_;
  rclcpp::Subscription<action_msgs::msg::GoalStatusArray>::SharedPtr status_;
  std::recursive_mutex mutex_;
  std::map<GoalUUID, typename GoalHandle::WeakPtr> handles_;
};

}  // namespace rclcpp_action
