// How a callback wants its message: as M, const M&, std::shared_ptr<M>, std::shared_ptr<const M>,
// MessageEvent<M> or MessageEvent<const M>, by value or by constant reference.
#pragma once

#include <memory>
#include <type_traits>

#include "message_filters/message_event.h"

namespace message_filters {
namespace detail {

template <typename M>
struct BareAdapter {
  using Message = M;
  using Event = MessageEvent<const M>;
  using Parameter = const M&;
  static constexpr bool is_const = true;
  static Parameter getParameter(const Event& event) { return *event.getConstMessage(); }
};

template <typename M>
struct BareAdapter<std::shared_ptr<M>> {
  using Message = std::remove_const_t<M>;
  using Event = MessageEvent<const Message>;
  using Parameter = std::shared_ptr<M>;
  static constexpr bool is_const = std::is_const_v<M>;
  static Parameter getParameter(const Event& event) { return MessageEvent<M>(event).getMessage(); }
};

template <typename M>
struct BareAdapter<MessageEvent<M>> {
  using Message = std::remove_const_t<M>;
  using Event = MessageEvent<const Message>;
  using Parameter = MessageEvent<M>;
  static constexpr bool is_const = std::is_const_v<M>;
  static Parameter getParameter(const Event& event) { return MessageEvent<M>(event); }
};

}  // namespace detail

template <typename P>
struct ParameterAdapter : detail::BareAdapter<std::remove_cv_t<std::remove_reference_t<P>>> {};

}  // namespace message_filters
