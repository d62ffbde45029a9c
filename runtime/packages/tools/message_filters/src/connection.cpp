// A connection to a filter.
#include "message_filters/connection.h"

namespace message_filters {

Connection::Connection(const VoidDisconnectFunction& func) : disconnect_(func) {}

void Connection::disconnect() {
  if (disconnect_) {
    disconnect_();
  }
}

}  // namespace message_filters
