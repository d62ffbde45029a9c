// Calls back with messages that have the same time.
#pragma once

#include <cstdint>
#include <tuple>
#include <utility>

#include "message_filters/sync_policies/exact_time.h"
#include "message_filters/synchronizer.h"

namespace message_filters {

template <class... Ms>
class TimeSynchronizer : public Synchronizer<sync_policies::ExactTime<Ms...>> {
 public:
  using Policy = sync_policies::ExactTime<Ms...>;
  using Base = Synchronizer<Policy>;

  explicit TimeSynchronizer(uint32_t queue_size) : Base(Policy(queue_size)) {}
  /// A filter for each message, and then how many times are kept.
  template <class F0, class... Rest, typename = std::enable_if_t<sizeof...(Rest) == sizeof...(Ms)>>
  explicit TimeSynchronizer(F0& f0, Rest&&... rest)
      : TimeSynchronizer(std::get<sizeof...(Rest) - 1>(std::tie(rest...))) {
    connect(std::tie(f0, rest...), std::index_sequence_for<Ms...>());
  }

 private:
  template <class Filters, std::size_t... i>
  void connect(Filters filters, std::index_sequence<i...>) {
    this->connectInput(std::get<i>(filters)...);
  }
};

}  // namespace message_filters
