// A subscription as a filter.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "message_filters/connection.h"
#include "message_filters/simple_filter.h"
#include "rclcpp/rclcpp.hpp"

namespace message_filters {

template <class NodeType = rclcpp::Node>
class SubscriberBase {
 public:
  using NodePtr = std::shared_ptr<NodeType>;

  virtual ~SubscriberBase() = default;

  /// Each ends an earlier subscription first. Nothing is subscribed with an empty topic.
  virtual void subscribe(NodePtr node, const std::string& topic,
                         const rmw_qos_profile_t qos = rmw_qos_profile_default) = 0;
  virtual void subscribe(NodeType* node, const std::string& topic,
                         const rmw_qos_profile_t qos = rmw_qos_profile_default) = 0;
  virtual void subscribe(NodePtr node, const std::string& topic, const rmw_qos_profile_t qos,
                         rclcpp::SubscriptionOptions options) {
    subscribe(node.get(), topic, qos, std::move(options));
  }
  virtual void subscribe(NodeType* node, const std::string& topic, const rmw_qos_profile_t qos,
                         rclcpp::SubscriptionOptions options) = 0;
  /// Once more, to what it was subscribed to.
  virtual void subscribe() = 0;
  virtual void unsubscribe() = 0;
};
template <typename T>
using SubscriberBasePtr = std::shared_ptr<SubscriberBase<T>>;

template <typename M, bool is_adapter = rclcpp::is_type_adapter<M>::value>
struct message_type;
template <typename M>
struct message_type<M, true> {
  using type = typename M::custom_type;
};
template <typename M>
struct message_type<M, false> {
  using type = M;
};
template <typename M>
using message_type_t = typename message_type<M>::type;

template <class M, class NodeType = rclcpp::Node>
class Subscriber : public SubscriberBase<NodeType>, public SimpleFilter<message_type_t<M>> {
 public:
  using NodePtr = std::shared_ptr<NodeType>;
  using MessageType = message_type_t<M>;
  using EventType = MessageEvent<const MessageType>;

  Subscriber() = default;
  Subscriber(NodePtr node, const std::string& topic,
             const rmw_qos_profile_t qos = rmw_qos_profile_default) {
    subscribe(std::move(node), topic, qos);
  }
  Subscriber(NodeType* node, const std::string& topic,
             const rmw_qos_profile_t qos = rmw_qos_profile_default) {
    subscribe(node, topic, qos);
  }
  Subscriber(NodePtr node, const std::string& topic, const rmw_qos_profile_t qos,
             rclcpp::SubscriptionOptions options) {
    subscribe(std::move(node), topic, qos, std::move(options));
  }
  Subscriber(NodeType* node, const std::string& topic, const rmw_qos_profile_t qos,
             rclcpp::SubscriptionOptions options) {
    subscribe(node, topic, qos, std::move(options));
  }
  Subscriber(NodePtr node, const std::string& topic, const rclcpp::QoS& qos,
             rclcpp::SubscriptionOptions options = rclcpp::SubscriptionOptions()) {
    subscribe(std::move(node), topic, qos, std::move(options));
  }
  Subscriber(NodeType* node, const std::string& topic, const rclcpp::QoS& qos,
             rclcpp::SubscriptionOptions options = rclcpp::SubscriptionOptions()) {
    subscribe(node, topic, qos, std::move(options));
  }
  ~Subscriber() override { unsubscribe(); }

  void subscribe(NodePtr node, const std::string& topic,
                 const rmw_qos_profile_t qos = rmw_qos_profile_default) override {
    subscribe(std::move(node), topic, qos, rclcpp::SubscriptionOptions());
  }
  void subscribe(NodeType* node, const std::string& topic,
                 const rmw_qos_profile_t qos = rmw_qos_profile_default) override {
    subscribe(node, topic, qos, rclcpp::SubscriptionOptions());
  }
  void subscribe(NodePtr node, const std::string& topic, const rmw_qos_profile_t qos,
                 rclcpp::SubscriptionOptions options) override {
    subscribe(std::move(node), topic, rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(qos), qos),
              std::move(options));
  }
  void subscribe(NodeType* node, const std::string& topic, const rmw_qos_profile_t qos,
                 rclcpp::SubscriptionOptions options) override {
    subscribe(node, topic, rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(qos), qos),
              std::move(options));
  }
  void subscribe(NodePtr node, const std::string& topic, const rclcpp::QoS& qos,
                 rclcpp::SubscriptionOptions options = rclcpp::SubscriptionOptions()) {
    subscribe(node.get(), topic, qos, std::move(options));
    node_shared_ = std::move(node);
  }
  void subscribe(NodeType* node, const std::string& topic, const rclcpp::QoS& qos,
                 rclcpp::SubscriptionOptions options = rclcpp::SubscriptionOptions()) {
    unsubscribe();
    if (topic.empty()) {
      return;
    }
    topic_ = topic;
    qos_ = qos;
    options_ = std::move(options);
    node_ = node;
    node_shared_.reset();
    subscribe();
  }
  void subscribe() override {
    if (node_ != nullptr) {
      subscription_ = node_->template create_subscription<M>(
          topic_, qos_,
          [this](const std::shared_ptr<const MessageType> message) {
            this->signalMessage(EventType(message));
          },
          options_);
    }
  }
  void unsubscribe() override { subscription_.reset(); }

  std::string getTopic() const { return topic_; }
  const typename rclcpp::Subscription<M>::SharedPtr getSubscriber() const { return subscription_; }

  /// Both do nothing: in a Chain, a subscriber is the first.
  template <typename F>
  void connectInput(F&) {}
  void add(const EventType&) {}

 private:
  typename rclcpp::Subscription<M>::SharedPtr subscription_;
  NodeType* node_ = nullptr;
  /// Kept when it was given.
  NodePtr node_shared_;
  std::string topic_;
  rclcpp::QoS qos_{10};
  rclcpp::SubscriptionOptions options_;
};

}  // namespace message_filters
