// Exceptions about transports.
#pragma once

#include <stdexcept>
#include <string>

namespace image_transport {

class Exception : public std::runtime_error {
 public:
  explicit Exception(const std::string& message) : std::runtime_error(message) {}
};

/// There is no such transport.
class TransportLoadException : public Exception {
 public:
  TransportLoadException(const std::string& transport, const std::string& message)
      : Exception("Unable to load plugin for transport '" + transport + "', error string:\n" +
                  message),
        transport_(transport) {}

  std::string getTransport() const { return transport_; }

 private:
  std::string transport_;
};

}  // namespace image_transport
