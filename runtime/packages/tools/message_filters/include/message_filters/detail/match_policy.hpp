// A policy of a synchronizer over one of the ways to match.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <tuple>
#include <utility>

#include "message_filters/detail/match.hpp"
#include "message_filters/message_traits.h"
#include "message_filters/synchronizer.h"

namespace message_filters::detail {

template <typename MatchT, typename... Ms>
class MatchPolicy : public PolicyBase<Ms...> {
  static_assert(sizeof...(Ms) >= 2 && sizeof...(Ms) <= kMaxMessages, "two to nine messages");

 public:
  using Super = PolicyBase<Ms...>;
  using Messages = typename Super::Messages;
  using Events = typename Super::Events;
  using Signal = typename Super::Signal;
  using RealTypeCount = typename Super::RealTypeCount;
  using Tuple = Events;

  /// Copies before they belong to a synchronizer.
  MatchPolicy(const MatchPolicy& other) : match_(other.match_) {}
  MatchPolicy& operator=(const MatchPolicy& other) {
    match_ = other.match_;
    return *this;
  }

  template <typename ParentT>
  void initParent(ParentT* parent) {
    matched_ = [parent](const MessageEvent<const Ms>&... events) { parent->signal(events...); };
  }

  template <int i>
  void add(const std::tuple_element_t<i, Events>& evt) {
    using Message = std::tuple_element_t<i, Messages>;
    const auto stamp = message_traits::TimeStamp<Message>::value(*evt.getConstMessage());
    match<i>(stamp.nanoseconds(), evt);
  }

 protected:
  explicit MatchPolicy(MatchT match) : match_(std::move(match)) {}

  template <int i>
  void match(int64_t stamp, const std::tuple_element_t<i, Events>& event) {
    // Held while callbacks run: sets come one after the other, whichever threads bring them.
    const std::lock_guard<std::mutex> lock(mutex_);
    const Outcome outcome =
        match_.add(i, stamp, std::make_shared<std::tuple_element_t<i, Events>>(event));
    for (const Row& row : outcome.matched) {
      tell(matched_, row, std::index_sequence_for<Ms...>());
    }
    const auto drop = [this](const auto&... events) { dropped_.call(events...); };
    for (const Row& row : outcome.dropped) {
      tell(drop, row, std::index_sequence_for<Ms...>());
    }
  }

  MatchT match_;
  Signal dropped_;

 private:
  template <typename HearerT, std::size_t... i>
  static void tell(const HearerT& hearer, const Row& row, std::index_sequence<i...>) {
    hearer(event_of<std::tuple_element_t<i, Events>>(row[i])...);
  }
  template <typename EventT>
  static EventT event_of(const Held& held) {
    return held == nullptr ? EventT() : *static_cast<const EventT*>(held.get());
  }

  std::mutex mutex_;
  std::function<void(const MessageEvent<const Ms>&...)> matched_;
};

}  // namespace message_filters::detail
