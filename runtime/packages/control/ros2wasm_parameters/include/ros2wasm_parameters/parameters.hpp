// Parameters of a node that are fields of a structure: declared with default, description and
// rules, read at the start, and followed while the node runs.
//
//   struct Params { double radius = 0.0; };
//   void describe(Declarations& of, Params& params) {
//     of.add("radius", params.radius, {"Radius of a wheel.", kReadOnly}, {gt(0.0)});
//   }
//   ParameterListener<Params> listener(node, describe);
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "rclcpp/node_interfaces/node_parameters_interface.hpp"
#include "rclcpp/parameter.hpp"
#include "ros2wasm_parameters/rules.hpp"

namespace ros2wasm_parameters {

enum Access : uint8_t { kDynamic, kReadOnly };

/// The part of a description that `ros2 param describe` prints.
struct About {
  std::string description;
  Access access = kDynamic;
};

/// Declares parameters and knows where their values go. The fields must live as long.
class Declarations {
 public:
  explicit Declarations(rclcpp::node_interfaces::NodeParametersInterface::SharedPtr node);

  /// Declares a parameter whose default is the field's value, unless the node has it already, and
  /// reads it. Throws rclcpp::exceptions::InvalidParameterValueException for a refused value, and
  /// InvalidParameterTypeException for one of another type.
  template <class T>
  void add(const std::string& name, T& field, const About& about,
           const std::vector<Rule<T>>& rules = {}) {
    double from = -std::numeric_limits<double>::infinity();
    double to = std::numeric_limits<double>::infinity();
    for (const Rule<T>& rule : rules) {
      from = std::max(from, rule.from);
      to = std::min(to, rule.to);
    }
    const rclcpp::Parameter now = declared(name, rclcpp::ParameterValue(field), about, from, to);
    Follower follower;
    follower.check = [name, rules](const rclcpp::Parameter& parameter) {
      const auto value = parameter.get_value<T>();
      for (const Rule<T>& rule : rules) {
        std::string why = rule.check(name, value);
        if (!why.empty()) return why;
      }
      return std::string();
    };
    follower.apply = [&field](const rclcpp::Parameter& parameter) {
      field = parameter.get_value<T>();
    };
    start(now, std::move(follower), about.access);
  }

  /// A reason why the values are refused, or an empty text. Changes nothing.
  std::string check(const std::vector<rclcpp::Parameter>& parameters) const;
  /// Stores them in the fields; returns whether there was one to store.
  bool apply(const std::vector<rclcpp::Parameter>& parameters) const;

 private:
  struct Follower {
    std::function<std::string(const rclcpp::Parameter&)> check;
    std::function<void(const rclcpp::Parameter&)> apply;
  };

  rclcpp::Parameter declared(const std::string& name, const rclcpp::ParameterValue& value,
                             const About& about, double from, double to);
  void start(const rclcpp::Parameter& now, Follower follower, Access access);

  rclcpp::node_interfaces::NodeParametersInterface::SharedPtr node_;
  std::map<std::string, Follower> followers_;  ///< of the parameters that may change
};

/// The values of `describe` with what has been set since.
template <class ParamsT>
class ParameterListener {
 public:
  using Describe = void (*)(Declarations&, ParamsT&);

  /// Throws as Declarations::add.
  template <class NodeT>
  ParameterListener(const NodeT& node, Describe describe, const ParamsT& defaults = ParamsT())
      : node_(node->get_node_parameters_interface()),
        describe_(describe),
        params_(defaults),
        declarations_(node_) {
    describe_(declarations_, params_);
    handle_ = node_->add_on_set_parameters_callback(
        [this](const std::vector<rclcpp::Parameter>& changed) { return on_set(changed); });
  }
  ~ParameterListener() { node_->remove_on_set_parameters_callback(handle_.get()); }
  ParameterListener(const ParameterListener&) = delete;
  ParameterListener& operator=(const ParameterListener&) = delete;

  ParamsT get_params() {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    is_new_ = false;
    return params_;
  }
  /// False when nothing has changed since the last look.
  bool try_update_params(ParamsT& params) {
    const std::unique_lock<std::recursive_mutex> lock(mutex_, std::try_to_lock);
    if (!lock.owns_lock() || !is_new_) return false;
    params = params_;
    is_new_ = false;
    return true;
  }
  /// Declares what has come with new keys of maps, e.g. gains of another joint.
  void refresh_dynamic_parameters() {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    describe_(declarations_, params_);
    is_new_ = true;
  }

 private:
  rcl_interfaces::msg::SetParametersResult on_set(const std::vector<rclcpp::Parameter>& changed) {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    rcl_interfaces::msg::SetParametersResult result;
    result.reason = declarations_.check(changed);
    result.successful = result.reason.empty();
    if (result.successful && declarations_.apply(changed)) is_new_ = true;
    return result;
  }

  rclcpp::node_interfaces::NodeParametersInterface::SharedPtr node_;
  Describe describe_;
  std::recursive_mutex mutex_;  ///< declaring a parameter calls on_set()
  ParamsT params_;
  bool is_new_ = false;
  Declarations declarations_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr handle_;
};

}  // namespace ros2wasm_parameters
