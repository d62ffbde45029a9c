// Calls back with one message of each of several filters, put together by a policy.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "message_filters/connection.h"
#include "message_filters/detail/callbacks.hpp"
#include "message_filters/message_event.h"
#include "message_filters/null_types.h"

namespace message_filters {

/// `Policy` is one of message_filters/sync_policies, or has the same interface.
template <class Policy>
class Synchronizer : public noncopyable, public Policy {
 public:
  using Messages = typename Policy::Messages;
  using Events = typename Policy::Events;
  using Signal = typename Policy::Signal;
  static constexpr std::size_t MAX_MESSAGES = detail::kMaxMessages;

  Synchronizer() { init(); }
  explicit Synchronizer(const Policy& policy) : Policy(policy) { init(); }
  template <class F0, class F1, class... Fs,
            typename = std::enable_if_t<!std::is_base_of_v<Policy, F0>>>
  Synchronizer(F0& f0, F1& f1, Fs&... fs) {
    connectInput(f0, f1, fs...);
    init();
  }
  template <class F0, class F1, class... Fs>
  Synchronizer(const Policy& policy, F0& f0, F1& f1, Fs&... fs) : Policy(policy) {
    connectInput(f0, f1, fs...);
    init();
  }
  ~Synchronizer() { disconnect_all(); }

  void init() { Policy::initParent(this); }

  /// One filter for each message.
  template <class... Fs>
  void connectInput(Fs&... filters) {
    static_assert(sizeof...(Fs) == std::tuple_size_v<Messages>, "a filter for each message");
    disconnect_all();
    connect(std::index_sequence_for<Fs...>(), filters...);
  }

  /// Anything that can be called with a parameter for each message, see ParameterAdapter.
  template <class C>
  Connection registerCallback(const C& callback) {
    return signal_.addCallback(callback);
  }
  template <class C, typename T>
  Connection registerCallback(C method, T* object) {
    return signal_.addCallback(method, object);
  }

  void setName(const std::string& name) { name_ = name; }
  const std::string& getName() { return name_; }

  template <class... Es>
  void signal(const Es&... events) {
    signal_.call(events...);
  }
  Policy* getPolicy() { return static_cast<Policy*>(this); }

  using Policy::add;
  template <int i>
  void add(const std::shared_ptr<const std::tuple_element_t<i, Messages>>& msg) {
    this->template add<i>(std::tuple_element_t<i, Events>(msg));
  }

 private:
  template <std::size_t... i, class... Fs>
  void connect(std::index_sequence<i...>, Fs&... filters) {
    (inputs_.push_back(
         filters.registerCallback([this](const std::tuple_element_t<i, Events>& event) {
           this->template add<static_cast<int>(i)>(event);
         })),
     ...);
  }
  void disconnect_all() {
    for (Connection& input : inputs_) {
      input.disconnect();
    }
    inputs_.clear();
  }

  Signal signal_;
  std::vector<Connection> inputs_;
  std::string name_;
};

/// The types that a synchronizer needs from its policy, which also has `add` and `initParent`.
template <typename... Ms>
struct PolicyBase {
  using RealTypeCount = std::integral_constant<int, sizeof...(Ms)>;
  using Messages = std::tuple<Ms...>;
  using Events = std::tuple<MessageEvent<const Ms>...>;
  using Signal = detail::Signal<Ms...>;
};

}  // namespace message_filters
