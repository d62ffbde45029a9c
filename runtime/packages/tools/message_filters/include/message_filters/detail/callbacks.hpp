// Callbacks in whichever form they come, and the list of those that wait for an event.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <mutex>
#include <type_traits>
#include <utility>
#include <vector>

#include "message_filters/connection.h"
#include "message_filters/message_event.h"
#include "message_filters/null_types.h"
#include "message_filters/parameter_adapter.h"

namespace message_filters::detail {

template <typename... P>
struct Parameters {};

/// The parameters of a callback, when it has one list of them.
template <typename C, typename = void>
struct ParametersOf {
  using type = void;
};
template <typename R, typename... P>
struct ParametersOf<R (*)(P...)> {
  using type = Parameters<P...>;
};
template <typename R, typename T, typename... P>
struct ParametersOf<R (T::*)(P...)> {
  using type = Parameters<P...>;
};
template <typename R, typename T, typename... P>
struct ParametersOf<R (T::*)(P...) const> {
  using type = Parameters<P...>;
};
template <typename C>
struct ParametersOf<C, std::void_t<decltype(&C::operator())>>
    : ParametersOf<decltype(&C::operator())> {};

/// Takes one event of each message, and whether a callback that changes the message gets a copy.
template <typename... Ms>
using EventCallback = std::function<void(const MessageEvent<const Ms>&..., bool)>;

template <typename... Ms, typename C, typename... P>
EventCallback<Ms...> with_parameters(C callback, Parameters<P...>) {
  return [callback = std::move(callback)](const MessageEvent<const Ms>&... events,
                                          bool copies) mutable {
    callback(ParameterAdapter<P>::getParameter(
        MessageEvent<const Ms>(events, copies || events.nonConstWillCopy()))...);
  };
}

inline constexpr std::size_t kMaxMessages = 9;

/// For those whose parameters are not known, such as what std::bind makes: they get pointers, and
/// those of nine parameters null pointers for the messages that there are not.
template <typename... Ms, typename C, std::size_t... Nulls>
EventCallback<Ms...> with_pointers(C callback, std::index_sequence<Nulls...>) {
  return [callback = std::move(callback)](const MessageEvent<const Ms>&... events, bool) mutable {
    if constexpr (std::is_invocable_v<C&, const std::shared_ptr<const Ms>&...>) {
      callback(events.getConstMessage()...);
    } else {
      callback(events.getConstMessage()..., ((void)Nulls, NullTypeConstPtr())...);
    }
  };
}

template <typename T, typename... Ms>
inline constexpr bool kFits = false;
template <typename... P, typename... Ms>
inline constexpr bool kFits<Parameters<P...>, Ms...> = sizeof...(P) == sizeof...(Ms);

template <typename... Ms, typename C>
EventCallback<Ms...> event_callback(C callback) {
  using Known = typename ParametersOf<C>::type;
  if constexpr (kFits<Known, Ms...>) {
    return with_parameters<Ms...>(std::move(callback), Known());
  } else {
    return with_pointers<Ms...>(std::move(callback),
                                std::make_index_sequence<kMaxMessages - sizeof...(Ms)>());
  }
}

template <typename... Ms, typename C, typename T>
EventCallback<Ms...> event_callback(C method, T* object) {
  using Known = typename ParametersOf<C>::type;
  static_assert(kFits<Known, Ms...>, "the method has not one parameter for each message");
  return with_parameters<Ms...>(
      [method, object](auto&&... arguments) {
        (object->*method)(std::forward<decltype(arguments)>(arguments)...);
      },
      Known());
}

/// A connection outlives the list without harm. Callbacks are called one after the other, may come
/// and go meanwhile, also by themselves, and are over when they have gone.
template <typename... Ms>
class Signal {
 public:
  template <typename... C>
  Connection addCallback(C... callback) {
    auto added = std::make_shared<EventCallback<Ms...>>(event_callback<Ms...>(callback...));
    const Lock lock(list_->mutex);
    list_->callbacks.push_back(added);
    return Connection([list = std::weak_ptr<List>(list_), added] {
      if (const auto there = list.lock()) {
        const Lock held(there->mutex);
        auto& all = there->callbacks;
        all.erase(std::remove(all.begin(), all.end(), added), all.end());
      }
    });
  }

  void call(const MessageEvent<const Ms>&... events) const {
    const auto list = list_;  // a callback may end its filter
    const Lock lock(list->mutex);
    const auto callbacks = list->callbacks;
    for (const auto& callback : callbacks) {
      const auto& left = list->callbacks;
      if (std::find(left.begin(), left.end(), callback) != left.end()) {
        (*callback)(events..., callbacks.size() > 1);
      }
    }
  }

 private:
  using Lock = std::lock_guard<std::recursive_mutex>;
  struct List {
    std::recursive_mutex mutex;
    std::vector<std::shared_ptr<EventCallback<Ms...>>> callbacks;
  };
  std::shared_ptr<List> list_ = std::make_shared<List>();
};

}  // namespace message_filters::detail
