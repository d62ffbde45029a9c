// Used by generated headers: the part of a ParamListener that is the same for all files of
// parameters.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "generate_parameter_library/fields.hpp"
#include "rcl_interfaces/msg/set_parameters_result.hpp"
#include "rclcpp/clock.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/time.hpp"
#include "rsl/parameter_validators.hpp"

namespace generate_parameter_library {

/// `ParamsT`: the generated structure. `DescriptionT` has `kName`, `add_fields(fields, params)` for
/// the parameters that are always there, and `add_entries(fields, params)` for those of maps.
template <class ParamsT, class DescriptionT>
class Listener {
 public:
  using userParameterUpdateCB = std::function<void(const ParamsT&)>;
  using ParametersInterface = rclcpp::node_interfaces::NodeParametersInterface;

  /// Throws as Fields::add().
  template <class NodeT>
  Listener(NodeT node, const std::string& prefix = "")
      : Listener(node->get_node_parameters_interface(), node->get_logger(), prefix) {}
  Listener(const std::shared_ptr<ParametersInterface>& parameters, const std::string& prefix = "")
      : Listener(parameters, rclcpp::get_logger(DescriptionT::kName), prefix) {}
  Listener(const std::shared_ptr<ParametersInterface>& parameters, rclcpp::Logger logger,
           const std::string& prefix = "")
      : prefix_(prefix), logger_(std::move(logger)), node_(parameters) {
    if (!prefix_.empty() && prefix_.back() != '.') prefix_ += '.';
    declare_params();
    handle_ = node_->add_on_set_parameters_callback(
        [this](const std::vector<rclcpp::Parameter>& changed) { return update(changed); });
  }

  ParamsT get_params() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return params_;
  }
  /// Never waits. True when `params` is now as new as can be.
  bool try_get_params(ParamsT& params) const {
    const std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock);
    if (lock.owns_lock() && params.__stamp != params_.__stamp) params = params_;
    return lock.owns_lock();
  }
  /// Never waits. True when `params` has changed.
  bool try_update_params(ParamsT& params) const {
    const std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock);
    if (!lock.owns_lock() || params.__stamp == params_.__stamp) return false;
    params = params_;
    return true;
  }
  bool is_old(const ParamsT& params) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return params.__stamp != params_.__stamp;
  }

  /// Declares all that is not declared, and reads all.
  void declare_params() {
    ParamsT params = get_params();
    Fields fields(*node_, logger_, prefix_);
    DescriptionT::add_fields(fields, params);
    DescriptionT::add_entries(fields, params);
    put(std::move(params));
  }
  /// Declares the parameters of new keys of maps. What is new comes in through update() too, as for
  /// every parameter that a node declares.
  void refresh_dynamic_parameters() {
    ParamsT params = get_params();
    Fields fields(*node_, logger_, prefix_);
    DescriptionT::add_entries(fields, params);
    if (fields.has_declared()) put(std::move(params));
  }
  /// Takes all of these, or none: those of others are passed over.
  rcl_interfaces::msg::SetParametersResult update(
      const std::vector<rclcpp::Parameter>& parameters) {
    ParamsT params = get_params();
    for (const auto add : {&DescriptionT::add_fields, &DescriptionT::add_entries}) {
      for (const rclcpp::Parameter& parameter : parameters) {
        Fields fields(parameter, logger_, prefix_);
        add(fields, params);
        if (!fields.result()) return rsl::to_parameter_result_msg(fields.result());
      }
    }
    put(params);
    if (user_callback_) user_callback_(params);
    return rsl::to_parameter_result_msg({});
  }

  /// `callback` gets the new values after each change.
  void setUserCallback(const userParameterUpdateCB& callback) { user_callback_ = callback; }
  void clearUserCallback() { user_callback_ = nullptr; }

 private:
  void put(ParamsT params) {
    const std::lock_guard<std::mutex> lock(mutex_);
    // Later than before, also where the clock stands still.
    const int64_t now = clock_.now().nanoseconds();
    params.__stamp = rclcpp::Time(std::max(now, params_.__stamp.nanoseconds() + 1),
                                  params_.__stamp.get_clock_type());
    params_ = std::move(params);
  }

  std::string prefix_;
  rclcpp::Logger logger_;
  std::shared_ptr<ParametersInterface> node_;
  rclcpp::Clock clock_;
  userParameterUpdateCB user_callback_;
  mutable std::mutex mutex_;
  ParamsT params_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr handle_;
};

}  // namespace generate_parameter_library
