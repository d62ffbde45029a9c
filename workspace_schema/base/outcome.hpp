// Outcome<T>: a value or the diagnostics that say why there is none.
// Errors are values up to the outermost layer; no exception crosses a folder.
#pragma once

#include <cassert>
#include <utility>
#include <variant>
#include <vector>

#include "workspace_schema/base/diagnostic.hpp"

namespace ros2wasm {

using Diagnostics = std::vector<Diagnostic>;

template <typename T>
class [[nodiscard]] Outcome {
 public:
  Outcome(T value)
      : state_(std::in_place_index<0>, std::move(value)) {}  // NOLINT: implicit on purpose
  Outcome(Diagnostic error)
      : state_(std::in_place_index<1>, Diagnostics{std::move(error)}) {}             // NOLINT
  Outcome(Diagnostics errors) : state_(std::in_place_index<1>, std::move(errors)) {  // NOLINT
    assert(!std::get<1>(state_).empty());
  }

  [[nodiscard]] bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  T& value() & { return std::get<0>(state_); }
  const T& value() const& { return std::get<0>(state_); }
  T&& value() && { return std::get<0>(std::move(state_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  const Diagnostics& errors() const& { return std::get<1>(state_); }
  Diagnostics&& errors() && { return std::get<1>(std::move(state_)); }

 private:
  std::variant<T, Diagnostics> state_;
};

/// For steps that yield nothing but success.
struct Done {};

}  // namespace ros2wasm
