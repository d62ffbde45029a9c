// Runs a function at the end of a scope.
#pragma once

#include <functional>
#include <type_traits>
#include <utility>

namespace rcpputils {

template <typename CallableT>
struct scope_exit final {
  explicit scope_exit(CallableT&& callable) : callable_(std::forward<CallableT>(callable)) {}
  scope_exit(const scope_exit&) = delete;
  scope_exit(scope_exit&&) = default;
  scope_exit& operator=(const scope_exit&) = delete;
  scope_exit& operator=(scope_exit&&) = default;
  ~scope_exit() {
    if (!cancelled_) {
      callable_();
    }
  }
  void cancel() { cancelled_ = true; }

 private:
  CallableT callable_;
  bool cancelled_ = false;
};

template <typename CallableT>
scope_exit<CallableT> make_scope_exit(CallableT&& callable) {
  return scope_exit<CallableT>(std::forward<CallableT>(callable));
}

}  // namespace rcpputils

#define RCPPUTILS_SCOPE_EXIT_JOIN_(A, B) A##B
#define RCPPUTILS_SCOPE_EXIT_NAME_(LINE) RCPPUTILS_SCOPE_EXIT_JOIN_(scope_exit_, LINE)
#define RCPPUTILS_SCOPE_EXIT(code) \
  auto RCPPUTILS_SCOPE_EXIT_NAME_(__LINE__) = ::rcpputils::make_scope_exit([&]() { code; })
