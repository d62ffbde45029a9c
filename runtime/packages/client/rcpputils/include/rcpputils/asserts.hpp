// Checks that throw.
#pragma once

#include <cassert>
#include <exception>
#include <stdexcept>
#include <string>

namespace rcpputils {

class AssertionException : public std::exception {
 public:
  explicit AssertionException(const char* msg) : message_(msg) {}
  const char* what() const noexcept override { return message_.c_str(); }

 private:
  std::string message_;
};

class IllegalStateException : public std::exception {
 public:
  explicit IllegalStateException(const char* msg) : message_(msg) {}
  const char* what() const noexcept override { return message_.c_str(); }

 private:
  std::string message_;
};

inline void require_true(bool condition, const std::string& msg = "invalid argument passed") {
  if (!condition) {
    throw std::invalid_argument{msg};
  }
}

inline void check_true(bool condition, const std::string& msg = "check reported invalid state") {
  if (!condition) {
    throw IllegalStateException{msg.c_str()};
  }
}

inline void assert_true(bool condition, const std::string& msg = "assertion failed") {
#ifndef NDEBUG
  if (!condition) {
    throw AssertionException{msg.c_str()};
  }
#else
  static_cast<void>(condition);
  static_cast<void>(msg);
#endif
}

}  // namespace rcpputils
