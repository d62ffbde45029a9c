// A command that one controller has claimed. It is given back when this goes.
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

class LoanedCommandInterface {
 public:
  using Deleter = std::function<void(void)>;

  [[deprecated("Replaced by the new version using shared_ptr")]] explicit LoanedCommandInterface(
      CommandInterface& command_interface)
      : command_interface_(command_interface) {}
  [[deprecated("Replaced by the new version using shared_ptr")]] LoanedCommandInterface(
      CommandInterface& command_interface, Deleter&& deleter)
      : command_interface_(command_interface), deleter_(std::move(deleter)) {}
  /// The owner of the interface outlives the loan.
  explicit LoanedCommandInterface(CommandInterface::SharedPtr command_interface, Deleter&& deleter)
      : command_interface_(*command_interface), deleter_(std::move(deleter)) {}

  LoanedCommandInterface(const LoanedCommandInterface& other) = delete;
  LoanedCommandInterface(LoanedCommandInterface&& other) noexcept
      : command_interface_(other.command_interface_),
        deleter_(std::exchange(other.deleter_, nullptr)),
        get_counts_(std::exchange(other.get_counts_, {})),
        set_counts_(std::exchange(other.set_counts_, {})) {}
  virtual ~LoanedCommandInterface() {
    get_counts_.report("LoanedCommandInterface", command_interface_, "get_value");
    set_counts_.report("LoanedCommandInterface", command_interface_, "set_value");
    if (deleter_) {
      deleter_();
    }
  }

  const std::string& get_name() const { return command_interface_.get_name(); }
  const std::string& get_interface_name() const { return command_interface_.get_interface_name(); }
  [[deprecated(
      "Replaced by get_name method, which is semantically more correct")]] const std::string
  get_full_name() const {
    return command_interface_.get_name();
  }
  const std::string& get_prefix_name() const { return command_interface_.get_prefix_name(); }

  /// False when another thread held the lock at each try.
  template <typename T>
  [[nodiscard]] bool set_value(const T& value, unsigned int max_tries = 10) {
    return set_counts_.repeat(max_tries,
                              [&] { return command_interface_.set_limited_value(value); });
  }

  [[deprecated("Use std::optional<T> get_optional() instead to retrieve the value.")]] double
  get_value() const {
    return get_optional().value_or(std::numeric_limits<double>::quiet_NaN());
  }
  template <typename T = double>
  [[nodiscard]] std::optional<T> get_optional(unsigned int max_tries = 10) const {
    std::optional<T> result;
    get_counts_.repeat(max_tries, [&] {
      result = command_interface_.template get_optional<T>();
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
  HandleDataType get_data_type() const { return command_interface_.get_data_type(); }

 protected:
  CommandInterface& command_interface_;
  Deleter deleter_;

 private:
  mutable detail::LoanCounts get_counts_;
  detail::LoanCounts set_counts_;
};

}  // namespace hardware_interface
