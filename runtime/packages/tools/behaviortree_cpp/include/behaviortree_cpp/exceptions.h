// The exceptions that behavior trees throw.
#pragma once

#include <stdexcept>
#include <string>

namespace BT {

class BehaviorTreeException : public std::runtime_error {
 public:
  explicit BehaviorTreeException(const std::string& message) : std::runtime_error(message) {}
  /// The parts make the message.
  template <typename... Parts>
  explicit BehaviorTreeException(const std::string& first, const Parts&... rest)
      : std::runtime_error((first + ... + std::string(rest))) {}
};

/// The code that uses a tree is wrong.
class LogicError : public BehaviorTreeException {
 public:
  using BehaviorTreeException::BehaviorTreeException;
};

/// The parts of a tree are wrong, or something went wrong while it ran.
class RuntimeError : public BehaviorTreeException {
 public:
  using BehaviorTreeException::BehaviorTreeException;
};

}  // namespace BT
