// A value, or the text of why there is none, with the names of nonstd::expected.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace nonstd {

template <typename ErrorT>
struct unexpected_type {
  ErrorT reason;
};
template <typename ErrorT>
unexpected_type<std::decay_t<ErrorT>> make_unexpected(ErrorT&& error) {
  return {std::forward<ErrorT>(error)};
}

/// Thrown when a value is asked for that is not there.
class bad_expected_access : public std::logic_error {
 public:
  explicit bad_expected_access(const std::string& why) : std::logic_error(why) {}
};

template <typename T, typename ErrorT>
class expected {
 public:
  using value_type = T;
  using error_type = ErrorT;

  expected() : value_(T()) {}
  expected(const T& value) : value_(value) {}
  expected(T&& value) : value_(std::move(value)) {}
  template <typename OtherT>
  expected(unexpected_type<OtherT> reason) : error_(std::move(reason.reason)) {}

  [[nodiscard]] bool has_value() const { return value_.has_value(); }
  explicit operator bool() const { return has_value(); }
  T& value() {
    if (!value_) throw bad_expected_access(error_);
    return *value_;
  }
  const T& value() const {
    if (!value_) throw bad_expected_access(error_);
    return *value_;
  }
  template <typename OtherT>
  T value_or(OtherT&& other) const {
    return value_ ? *value_ : static_cast<T>(std::forward<OtherT>(other));
  }
  T& operator*() { return *value_; }
  const T& operator*() const { return *value_; }
  T* operator->() { return &*value_; }
  const T* operator->() const { return &*value_; }
  const ErrorT& error() const { return error_; }

 private:
  std::optional<T> value_;
  ErrorT error_;  ///< empty when there is a value
};

}  // namespace nonstd
