// A bond: two nodes send each other heartbeats on a topic, and each notices when the other one ends
// or goes silent. Both ends have the same topic and id.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "bond/msg/constants.hpp"
#include "bond/msg/status.hpp"
#include "bondcpp/detail/bond_state.hpp"
#include "bondcpp/visibility_control.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace bond {

class Bond : public std::enable_shared_from_this<Bond> {
 public:
  using EventCallback = std::function<void()>;

  /// Does not connect before start(). Timers and the subscription are in `callback_group` (the
  /// default group of the node when there is none), which only the packages of ros2wasm set.
  Bond(const std::string& topic, const std::string& id,
       rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base,
       rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr node_logging,
       rclcpp::node_interfaces::NodeParametersInterface::SharedPtr node_params,
       rclcpp::node_interfaces::NodeTimersInterface::SharedPtr node_timers,
       rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr node_topics,
       EventCallback on_broken = EventCallback(), EventCallback on_formed = EventCallback(),
       rclcpp::CallbackGroup::SharedPtr callback_group = nullptr);
  Bond(const std::string& topic, const std::string& id,
       rclcpp_lifecycle::LifecycleNode::SharedPtr nh, EventCallback on_broken = EventCallback(),
       EventCallback on_formed = EventCallback());
  Bond(const std::string& topic, const std::string& id, rclcpp::Node::SharedPtr nh,
       EventCallback on_broken = EventCallback(), EventCallback on_formed = EventCallback());
  /// Breaks the bond, and waits up to 100 ms for the other end to confirm.
  ~Bond();
  Bond(const Bond&) = delete;
  Bond& operator=(const Bond&) = delete;

  /// Gives all times their defaults (bond/msg/Constants).
  void setupConnections();

  /// Times in seconds. After start() they cannot be set: an error is logged.
  double getConnectTimeout() const { return times_.connect; }
  void setConnectTimeout(double dur);
  double getDisconnectTimeout() const { return times_.disconnect; }
  void setDisconnectTimeout(double dur);
  double getHeartbeatTimeout() const { return times_.heartbeat; }
  void setHeartbeatTimeout(double dur);
  double getHeartbeatPeriod() const { return times_.period; }
  void setHeartbeatPeriod(double dur);
  double getDeadPublishPeriod() const { return times_.dead_period; }
  void setDeadPublishPeriod(double dur);

  void connectTimerReset();
  void connectTimerCancel();
  void disconnectTimerReset();
  void disconnectTimerCancel();
  void heartbeatTimerReset();
  void heartbeatTimerCancel();
  void publishingTimerReset();
  void publishingTimerCancel();
  void deadpublishingTimerReset();
  void deadpublishingTimerCancel();

  void start();
  void setFormedCallback(EventCallback on_formed);
  void setBrokenCallback(EventCallback on_broken);

  /// True once the bond is formed, even if it is broken by then. These wait while another thread
  /// spins the node; a negative timeout never ends.
  bool waitUntilFormed(rclcpp::Duration timeout = rclcpp::Duration(std::chrono::seconds(-1)));
  bool waitUntilBroken(rclcpp::Duration timeout = rclcpp::Duration(std::chrono::seconds(-1)));
  bool isBroken();
  /// Tells the other end.
  void breakBond();

  std::string getTopic() const { return topic_; }
  std::string getId() const { return id_; }
  std::string getInstanceId() const { return instance_id_; }

 private:
  using State = detail::BondState;
  using Event = detail::BondEvent;
  /// In seconds.
  struct Times {
    double connect = 0;
    double disconnect = 0;
    double heartbeat = 0;
    double period = 0;
    double dead_period = 0;
  };

  void set_time(double& time, double value);
  State state();
  /// The other end left first: it wants to hear that this was noticed.
  bool sister_left();
  void happen(Event event);
  void receive(const bond::msg::Status& status);
  void publish_due();
  void publish_status(bool active);
  void run_callbacks();
  bool wait_for(const std::function<bool(State)>& is_reached, rclcpp::Duration timeout);
  rclcpp::TimerBase::SharedPtr make_timer(double period_s, std::function<void()> callback);
  void subscribe();

  const rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base_;
  const rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr node_logging_;
  const rclcpp::node_interfaces::NodeTimersInterface::SharedPtr node_timers_;
  const rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr node_topics_;
  const rclcpp::CallbackGroup::SharedPtr callback_group_;
  const std::string topic_;
  const std::string id_;
  const std::string instance_id_;
  Times times_;
  bool started_ = false;
  /// This node does not end its bonds for want of heartbeats.
  bool ignores_silence_ = false;

  std::mutex mutex_;  // guards the next five members
  State state_ = State::kWaitingForSister;
  bool sister_left_ = false;
  EventCallback on_broken_;
  EventCallback on_formed_;
  std::vector<EventCallback> due_callbacks_;

  rclcpp::TimerBase::SharedPtr connect_timer_;
  rclcpp::TimerBase::SharedPtr disconnect_timer_;
  rclcpp::TimerBase::SharedPtr heartbeat_timer_;
  rclcpp::TimerBase::SharedPtr publishing_timer_;
  rclcpp::TimerBase::SharedPtr dead_timer_;
  rclcpp::Publisher<bond::msg::Status>::SharedPtr publisher_;
  rclcpp::Subscription<bond::msg::Status>::SharedPtr subscription_;
};

}  // namespace bond
