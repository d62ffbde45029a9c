// A state that a controller reads. It is given back when this goes.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "hardware_interface/handle.hpp"
#include "hardware_interface/loan_counts.hpp"

namespace hardware_interface {

class LoanedStateInterface {
 public:
  using Deleter = std::function<void(void)>;

  [[deprecated("Replaced by the new version using shared_ptr")]] explicit LoanedStateInterface(
      const StateInterface& state_interface)
      : state_interface_(state_interface) {}
  [[deprecated("Replaced by the new version using shared_ptr")]] LoanedStateInterface(
      const StateInterface& state_interface, Deleter&& deleter)
      : state_interface_(state_interface), deleter_(std::move(deleter)) {}
  /// The owner of the interface outlives the loan.
  explicit LoanedStateInterface(StateInterface::ConstSharedPtr state_interface,
                                Deleter&& deleter = nullptr)
      : state_interface_(*state_interface), deleter_(std::move(deleter)) {}

  LoanedStateInterface(const LoanedStateInterface& other) = delete;
  LoanedStateInterface(LoanedStateInterface&& other) noexcept
      : state_interface_(other.state_interface_),
        deleter_(std::exchange(other.deleter_, nullptr)),
        get_counts_(std::exchange(other.get_counts_, {})) {}
  virtual ~LoanedStateInterface() {
    get_counts_.report("LoanedStateInterface", state_interface_, "get_value");
    if (deleter_) {
      deleter_();
    }
  }

  const std::string& get_name() const { return state_interface_.get_name(); }
  const std::string& get_interface_name() const { return state_interface_.get_interface_name(); }
  [[deprecated(
      "Replaced by get_name method, which is semantically more correct")]] const std::string
  get_full_name() const {
    return state_interface_.get_name();
  }
  const std::string& get_prefix_name() const { return state_interface_.get_prefix_name(); }

  [[deprecated("Use std::optional<T> get_optional() instead to retrieve the value.")]] double
  get_value() const {
    return get_optional().value_or(std::numeric_limits<double>::quiet_NaN());
  }
  template <typename T = double>
  [[nodiscard]] std::optional<T> get_optional(unsigned int max_tries = 10) const {
    std::optional<T> result;
    get_counts_.repeat(max_tries, [&] {
      result = state_interface_.template get_optional<T>();
      return result.has_value();
    });
    return result;
  }
  template <typename T>
  [[deprecated(
      "Use std::optional<T> get_optional() instead to retrieve the value.")]] [[nodiscard]] bool
  get_value(T& value, unsigned int max_tries = 10) const {
    const auto found = get_optional<T>(max_tries);
    if (found.has_value()) {
      value = *found;
    }
    return found.has_value();
  }
  HandleDataType get_data_type() const { return state_interface_.get_data_type(); }

 protected:
  const StateInterface& state_interface_;
  Deleter deleter_;

 private:
  mutable detail::LoanCounts get_counts_;
};

}  // namespace hardware_interface
