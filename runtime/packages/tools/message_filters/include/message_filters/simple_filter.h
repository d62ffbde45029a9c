// Base class of all filters with one output: calls back for each message that passes.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "message_filters/connection.h"
#include "message_filters/detail/callbacks.hpp"
#include "message_filters/message_event.h"

namespace message_filters {

template <class M>
class SimpleFilter : public noncopyable {
 public:
  using MConstPtr = std::shared_ptr<const M>;
  using Callback = std::function<void(const MConstPtr&)>;
  using EventType = MessageEvent<const M>;
  using EventCallback = std::function<void(const EventType&)>;

  /// A function, or anything else that can be called; see ParameterAdapter for its parameter.
  template <typename C>
  Connection registerCallback(const C& callback) {
    return signal_.addCallback(callback);
  }
  /// With its parameter named: `registerCallback<M::SharedPtr>([](const auto& message) {...})`.
  template <typename P>
  Connection registerCallback(const std::function<void(P)>& callback) {
    return signal_.addCallback(callback);
  }
  template <typename C, typename T>
  Connection registerCallback(C method, T* object) {
    return signal_.addCallback(method, object);
  }

  void setName(const std::string& name) { name_ = name; }
  const std::string& getName() { return name_; }

 protected:
  void signalMessage(const MConstPtr& msg) { signal_.call(EventType(msg)); }
  void signalMessage(const EventType& event) { signal_.call(event); }

 private:
  detail::Signal<M> signal_;
  std::string name_;
};

}  // namespace message_filters
