// A publisher that says nothing while it is not activated.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <utility>

#include "rclcpp/logging.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp_lifecycle/managed_entity.hpp"

namespace rclcpp_lifecycle {

template <typename MessageT, typename Alloc = std::allocator<void>>
class LifecyclePublisher : public SimpleManagedEntity, public rclcpp::Publisher<MessageT, Alloc> {
  using Base = rclcpp::Publisher<MessageT, Alloc>;

 public:
  RCLCPP_SMART_PTR_DEFINITIONS(LifecyclePublisher)

  using MessageDeleter = typename Base::PublishedTypeDeleter;
  using MessageUniquePtr = std::unique_ptr<typename Base::PublishedType, MessageDeleter>;

  LifecyclePublisher(rclcpp::node_interfaces::NodeBaseInterface* node_base,
                     const std::string& topic, const rclcpp::QoS& qos,
                     const rclcpp::PublisherOptionsWithAllocator<Alloc>& options)
      : Base(node_base, topic, qos, options), logger_(rclcpp::get_logger("LifecyclePublisher")) {}

  virtual void publish(MessageUniquePtr msg) {
    if (may_publish()) {
      Base::publish(std::move(msg));
    }
  }

  virtual void publish(const typename Base::PublishedType& msg) {
    if (may_publish()) {
      Base::publish(msg);
    }
  }

  virtual void publish(rclcpp::LoanedMessage<typename Base::ROSMessageType, Alloc>&& loaned_msg) {
    if (may_publish()) {
      Base::publish(std::move(loaned_msg));
    }
  }

  void on_activate() override {
    SimpleManagedEntity::on_activate();
    warned_ = false;
  }

 private:
  /// Warns of the first message that is dropped since the last activation.
  bool may_publish() {
    if (this->is_activated()) {
      return true;
    }
    if (!warned_.exchange(true)) {
      RCLCPP_WARN(logger_,
                  "Trying to publish message on the topic '%s', but the publisher is not activated",
                  this->get_topic_name());
    }
    return false;
  }

  std::atomic<bool> warned_ = false;
  rclcpp::Logger logger_;
};

}  // namespace rclcpp_lifecycle
