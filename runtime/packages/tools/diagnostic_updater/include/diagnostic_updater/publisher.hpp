// Diagnostics of topics: how often messages go out, and how old they are.
#pragma once

#include <memory>
#include <string>

#include "diagnostic_updater/update_functions.hpp"

namespace diagnostic_updater {

class HeaderlessTopicDiagnostic : public CompositeDiagnosticTask {
 public:
  HeaderlessTopicDiagnostic(std::string name, diagnostic_updater::Updater& diag,
                            const diagnostic_updater::FrequencyStatusParam& freq)
      : CompositeDiagnosticTask(name + " topic status"), freq_(freq) {
    addTask(&freq_);
    diag.add(*this);
  }
  virtual void tick() { freq_.tick(); }
  virtual void clear_window() { freq_.clear(); }

 private:
  diagnostic_updater::FrequencyStatus freq_;
};

class TopicDiagnostic : public HeaderlessTopicDiagnostic {
 public:
  TopicDiagnostic(std::string name, diagnostic_updater::Updater& diag,
                  const diagnostic_updater::FrequencyStatusParam& freq,
                  const diagnostic_updater::TimeStampStatusParam& stamp)
      : HeaderlessTopicDiagnostic(name, diag, freq), stamp_(stamp) {
    addTask(&stamp_);
  }
  void tick() override {
    RCLCPP_FATAL(rclcpp::get_logger("TopicDiagnostic"),
                 "tick(void) has been called on a TopicDiagnostic. This is never correct. Use "
                 "tick(rclcpp::Time &) instead.");
  }
  virtual void tick(const rclcpp::Time& stamp) {
    stamp_.tick(stamp);
    HeaderlessTopicDiagnostic::tick();
  }

 private:
  TimeStampStatus stamp_;
};

template <class MessageT, typename AllocatorT = std::allocator<void>>
class DiagnosedPublisher : public TopicDiagnostic {
 public:
  using PublisherT = rclcpp::Publisher<MessageT, AllocatorT>;

  DiagnosedPublisher(const typename PublisherT::SharedPtr& pub, diagnostic_updater::Updater& diag,
                     const diagnostic_updater::FrequencyStatusParam& freq,
                     const diagnostic_updater::TimeStampStatusParam& stamp)
      : TopicDiagnostic(pub->get_topic_name(), diag, freq, stamp), publisher_(pub) {}
  ~DiagnosedPublisher() override = default;

  virtual void publish(typename PublisherT::MessageUniquePtr message) {
    tick(message->header.stamp);
    publisher_->publish(std::move(message));
  }
  virtual void publish(const MessageT& message) {
    tick(message.header.stamp);
    publisher_->publish(message);
  }
  typename PublisherT::SharedPtr getPublisher() const { return publisher_; }
  void setPublisher(typename PublisherT::SharedPtr pub) { publisher_ = pub; }

 private:
  typename PublisherT::SharedPtr publisher_;
};

}  // namespace diagnostic_updater
