// The result of registering a callback; it can remove the callback again.
#pragma once

#include <functional>

#include "message_filters/visibility_control.h"

namespace message_filters {

class noncopyable {
 protected:
  noncopyable() = default;
  ~noncopyable() = default;
  noncopyable(const noncopyable&) = delete;
  noncopyable& operator=(const noncopyable&) = delete;
};

class Connection {
 public:
  using VoidDisconnectFunction = std::function<void(void)>;
  using WithConnectionDisconnectFunction = std::function<void(const Connection&)>;

  Connection() = default;
  Connection(const VoidDisconnectFunction& func);  // NOLINT: conversion wanted

  /// The callback is not called any more. It may be done twice, and after the filter is gone.
  void disconnect();

 private:
  VoidDisconnectFunction disconnect_;
};

}  // namespace message_filters
