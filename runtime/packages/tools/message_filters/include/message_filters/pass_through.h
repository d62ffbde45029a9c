// A filter that lets everything pass.
#pragma once

#include <memory>

#include "message_filters/simple_filter.h"

namespace message_filters {

template <typename M>
class PassThrough : public SimpleFilter<M> {
 public:
  using MConstPtr = std::shared_ptr<const M>;
  using EventType = MessageEvent<const M>;

  PassThrough() = default;
  template <typename F>
  explicit PassThrough(F& f) {
    connectInput(f);
  }
  ~PassThrough() { incoming_.disconnect(); }

  template <class F>
  void connectInput(F& f) {
    incoming_.disconnect();
    incoming_ = f.registerCallback([this](const EventType& event) { add(event); });
  }

  void add(const MConstPtr& msg) { add(EventType(msg)); }
  void add(const EventType& evt) { this->signalMessage(evt); }

 private:
  Connection incoming_;
};

}  // namespace message_filters
