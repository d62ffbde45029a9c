// Stand for the messages that a synchronizer of fewer than nine has not.
#pragma once

#include <memory>

#include "message_filters/connection.h"

namespace message_filters {

struct NullType {};
using NullTypeConstPtr = std::shared_ptr<const NullType>;

/// Never calls anybody.
template <class M>
struct NullFilter {
  template <typename C>
  Connection registerCallback(const C&) {
    return Connection();
  }
};

}  // namespace message_filters
