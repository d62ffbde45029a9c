// Declaring, checking and setting parameters.
#include "rclcpp/node_interfaces/node_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "rcl_interfaces/srv/list_parameters.hpp"
#include "rclcpp/create_publisher.hpp"
#include "rclcpp/detail/parameter_overrides.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/parameter_service.hpp"

namespace rclcpp {
namespace node_interfaces {
namespace {

using rcl_interfaces::msg::ParameterDescriptor;
using rcl_interfaces::msg::SetParametersResult;

// Callbacks must not change parameters in turn.
class ChangeGuard {
 public:
  explicit ChangeGuard(bool& changing) : changing_(changing) {
    if (changing_) {
      throw exceptions::ParameterModifiedInCallbackException(
          "cannot set or declare a parameter, or change the callback from within set callback");
    }
    changing_ = true;
  }
  ~ChangeGuard() { changing_ = false; }

 private:
  bool& changing_;
};

SetParametersResult accepted() {
  SetParametersResult result;
  result.successful = true;
  return result;
}

SetParametersResult refused(const std::string& reason) {
  SetParametersResult result;
  result.successful = false;
  result.reason = reason;
  return result;
}

bool nearly_equal(double x, double y) {
  constexpr double kSteps = 100.0;
  return std::abs(x - y) <= std::numeric_limits<double>::epsilon() * std::abs(x + y) * kSteps;
}

bool fits(int64_t value, const rcl_interfaces::msg::IntegerRange& range) {
  if (value == range.from_value || value == range.to_value) {
    return true;
  }
  if (value < range.from_value || value > range.to_value) {
    return false;
  }
  return range.step == 0 ||
         (static_cast<uint64_t>(value) - static_cast<uint64_t>(range.from_value)) % range.step == 0;
}

bool fits(double value, const rcl_interfaces::msg::FloatingPointRange& range) {
  if (nearly_equal(value, range.from_value) || nearly_equal(value, range.to_value)) {
    return true;
  }
  if (value < range.from_value || value > range.to_value) {
    return false;
  }
  if (range.step == 0.0) {
    return true;
  }
  const double steps = std::round((value - range.from_value) / range.step);
  return nearly_equal(value, range.from_value + steps * range.step);
}

SetParametersResult check_range(const std::string& name, const ParameterDescriptor& descriptor,
                                const ParameterValue& value) {
  const auto out_of = [&name](const char* kind) {
    return refused("Parameter {" + name + "} doesn't comply with " + kind + " range.");
  };
  if (!descriptor.integer_range.empty() && value.get_type() == PARAMETER_INTEGER &&
      !fits(value.get<int64_t>(), descriptor.integer_range[0])) {
    return out_of("integer");
  }
  if (!descriptor.floating_point_range.empty() && value.get_type() == PARAMETER_DOUBLE &&
      !fits(value.get<double>(), descriptor.floating_point_range[0])) {
    return out_of("floating point");
  }
  return accepted();
}

constexpr char kWrongType[] = "Wrong parameter type";

SetParametersResult check_value(const std::string& name, const ParameterDescriptor& descriptor,
                                const ParameterValue& value) {
  const auto wanted = static_cast<ParameterType>(descriptor.type);
  if (!descriptor.dynamic_typing && wanted != value.get_type()) {
    return refused(std::string(kWrongType) + ", parameter {" + name + "} is of type {" +
                   to_string(wanted) + "}, setting it to {" + to_string(value.get_type()) +
                   "} is not allowed.");
  }
  return check_range(name, descriptor, value);
}

template <typename HandleT, typename CallT>
void call_each(std::list<std::weak_ptr<HandleT>>& handles, const CallT& call) {
  for (auto it = handles.begin(); it != handles.end();) {
    if (const auto handle = it->lock()) {
      if (!call(*handle)) {
        return;
      }
      ++it;
    } else {
      it = handles.erase(it);
    }
  }
}

template <typename HandleT, typename CallbackT>
std::shared_ptr<HandleT> add_handle(std::list<std::weak_ptr<HandleT>>& handles,
                                    CallbackT callback) {
  auto handle = std::make_shared<HandleT>();
  handle->callback = std::move(callback);
  // The last registered is called first.
  handles.push_front(handle);
  return handle;
}

template <typename HandleT>
void remove_handle(std::list<std::weak_ptr<HandleT>>& handles, const HandleT* handle,
                   const char* absent) {
  const auto found = std::find_if(handles.begin(), handles.end(), [handle](const auto& weak) {
    return weak.lock().get() == handle;
  });
  if (found == handles.end()) {
    throw std::runtime_error(absent);
  }
  handles.erase(found);
}

}  // namespace

NodeParameters::NodeParameters(const NodeBaseInterface::SharedPtr& node_base,
                               const NodeLoggingInterface::SharedPtr&,
                               const NodeTopicsInterface::SharedPtr& node_topics,
                               const NodeServicesInterface::SharedPtr& node_services,
                               const NodeClockInterface::SharedPtr& node_clock,
                               const NodeParametersOptions& options)
    : allow_undeclared_(options.allow_undeclared_parameters),
      node_name_(node_base->get_fully_qualified_name()),
      node_clock_(node_clock) {
  if (options.start_parameter_services) {
    parameter_service_ = std::make_shared<ParameterService>(node_base, node_services, this);
  }
  if (options.start_parameter_event_publisher) {
    events_publisher_ = rclcpp::create_publisher<rcl_interfaces::msg::ParameterEvent>(
        node_topics, "/parameter_events", options.parameter_event_qos,
        rclcpp::PublisherOptions(options.parameter_event_publisher_options));
  }
  overrides_ = rclcpp::detail::resolve_parameter_overrides(*node_base, options.parameter_overrides);
  if (options.automatically_declare_parameters_from_overrides) {
    ParameterDescriptor descriptor;
    descriptor.dynamic_typing = true;
    for (const auto& [name, value] : overrides_) {
      if (!has_parameter(name)) {
        declare_parameter(name, value, descriptor, true);
      }
    }
  }
}

NodeParameters::~NodeParameters() = default;

void NodeParameters::publish(rcl_interfaces::msg::ParameterEvent event) {
  if (events_publisher_) {
    event.node = node_name_;
    event.stamp = node_clock_->get_clock()->now();
    events_publisher_->publish(event);
  }
}

NodeParameters::SetResult NodeParameters::ask_callbacks(
    const std::vector<rclcpp::Parameter>& parameters) {
  SetResult result = accepted();
  call_each(on_set_callbacks_, [&](const OnSetParametersCallbackHandle& handle) {
    result = handle.callback(parameters);
    return result.successful;
  });
  return result;
}

void NodeParameters::tell_callbacks(const std::vector<rclcpp::Parameter>& parameters) {
  call_each(post_set_callbacks_, [&](const PostSetParametersCallbackHandle& handle) {
    handle.callback(parameters);
    return true;
  });
}

const ParameterValue& NodeParameters::declare(const std::string& name, ParameterType type,
                                              const ParameterValue& default_value,
                                              ParameterDescriptor descriptor,
                                              bool ignore_override) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  const ChangeGuard guard(changing_);
  if (name.empty()) {
    throw exceptions::InvalidParametersException("parameter name must not be empty");
  }
  if (parameters_.count(name) != 0) {
    throw exceptions::ParameterAlreadyDeclaredException("parameter '" + name +
                                                        "' has already been declared");
  }
  descriptor.name = name;
  if (!descriptor.dynamic_typing) {
    type = type == PARAMETER_NOT_SET ? default_value.get_type() : type;
    if (type == PARAMETER_NOT_SET) {
      throw exceptions::InvalidParameterTypeException(
          name, "cannot declare a statically typed parameter with an uninitialized value");
    }
    descriptor.type = type;
  }
  const auto given = overrides_.find(name);
  const ParameterValue& value =
      !ignore_override && given != overrides_.end() ? given->second : default_value;
  if (value.get_type() == PARAMETER_NOT_SET) {
    descriptor.type =
        descriptor.dynamic_typing ? static_cast<uint8_t>(PARAMETER_NOT_SET) : descriptor.type;
    parameters_[name].descriptor = descriptor;
    publish(rcl_interfaces::msg::ParameterEvent());
    return parameters_[name].value;
  }
  const std::vector<rclcpp::Parameter> parameters{rclcpp::Parameter(name, value)};
  SetResult result = check_value(name, descriptor, value);
  if (result.successful) {
    result = ask_callbacks(parameters);
  }
  if (!result.successful) {
    if (result.reason.compare(0, sizeof(kWrongType) - 1, kWrongType) == 0) {
      throw exceptions::InvalidParameterTypeException(name, result.reason);
    }
    throw exceptions::InvalidParameterValueException("parameter '" + name +
                                                     "' could not be set: " + result.reason);
  }
  descriptor.type = value.get_type();
  parameters_[name] = ParameterInfo{value, descriptor};
  tell_callbacks(parameters);
  rcl_interfaces::msg::ParameterEvent event;
  event.new_parameters.push_back(parameters[0].to_parameter_msg());
  publish(std::move(event));
  return parameters_.at(name).value;
}

const ParameterValue& NodeParameters::declare_parameter(const std::string& name,
                                                        const ParameterValue& default_value,
                                                        const ParameterDescriptor& descriptor,
                                                        bool ignore_override) {
  return declare(name, PARAMETER_NOT_SET, default_value, descriptor, ignore_override);
}

const ParameterValue& NodeParameters::declare_parameter(const std::string& name, ParameterType type,
                                                        const ParameterDescriptor& descriptor,
                                                        bool ignore_override) {
  if (type == PARAMETER_NOT_SET) {
    throw std::invalid_argument(
        "declare_parameter(): the provided parameter type cannot be rclcpp::PARAMETER_NOT_SET");
  }
  if (descriptor.dynamic_typing) {
    throw std::invalid_argument(
        "declare_parameter(): cannot declare parameter of specific type and pass descriptor"
        "with `dynamic_typing=true`");
  }
  return declare(name, type, ParameterValue(), descriptor, ignore_override);
}

void NodeParameters::undeclare_parameter(const std::string& name) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  const ChangeGuard guard(changing_);
  const auto found = parameters_.find(name);
  if (found == parameters_.end()) {
    throw exceptions::ParameterNotDeclaredException("cannot undeclare parameter '" + name +
                                                    "' which has not yet been declared");
  }
  if (found->second.descriptor.read_only) {
    throw exceptions::ParameterImmutableException("cannot undeclare parameter '" + name +
                                                  "' because it is read-only");
  }
  if (!found->second.descriptor.dynamic_typing) {
    throw exceptions::InvalidParameterTypeException(
        name, "cannot undeclare a statically typed parameter");
  }
  parameters_.erase(found);
}

bool NodeParameters::has_parameter(const std::string& name) const {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  return parameters_.count(name) != 0;
}

std::vector<SetParametersResult> NodeParameters::set_parameters(
    const std::vector<rclcpp::Parameter>& parameters) {
  std::vector<SetParametersResult> results;
  for (const rclcpp::Parameter& parameter : parameters) {
    results.push_back(set_parameters_atomically({parameter}));
  }
  return results;
}

NodeParameters::SetResult NodeParameters::check(const std::vector<rclcpp::Parameter>& parameters,
                                                const Infos& infos) const {
  for (const rclcpp::Parameter& parameter : parameters) {
    const auto found = infos.find(parameter.get_name());
    ParameterDescriptor descriptor;
    descriptor.dynamic_typing = true;
    const SetResult result = check_value(
        parameter.get_name(), found == infos.end() ? descriptor : found->second.descriptor,
        parameter.get_parameter_value());
    if (!result.successful) {
      return result;
    }
  }
  return accepted();
}

SetParametersResult NodeParameters::set_parameters_atomically(
    const std::vector<rclcpp::Parameter>& asked) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  const ChangeGuard guard(changing_);
  std::vector<rclcpp::Parameter> parameters = asked;
  call_each(pre_set_callbacks_, [&](const PreSetParametersCallbackHandle& handle) {
    handle.callback(parameters);
    return true;
  });
  if (parameters.empty()) {
    return refused(
        "parameter list cannot be empty, this might be due to "
        "pre_set_parameters_callback modifying the original parameters list.");
  }
  std::set<std::string> removed;
  for (const rclcpp::Parameter& parameter : parameters) {
    const std::string& name = parameter.get_name();
    if (name.empty()) {
      throw exceptions::InvalidParametersException("parameter name must not be empty");
    }
    const auto found = parameters_.find(name);
    if (found == parameters_.end()) {
      if (!allow_undeclared_) {
        throw exceptions::ParameterNotDeclaredException(
            "parameter '" + name + "' cannot be set because it was not declared");
      }
      continue;
    }
    const ParameterInfo& info = found->second;
    if (info.descriptor.read_only) {
      return refused("parameter '" + name + "' cannot be set because it is read-only");
    }
    if (parameter.get_type() == PARAMETER_NOT_SET && info.value.get_type() != PARAMETER_NOT_SET) {
      if (!info.descriptor.dynamic_typing) {
        return refused("cannot undeclare a statically typed parameter");
      }
      removed.insert(name);
    }
  }
  SetResult result = check(parameters, parameters_);
  if (result.successful) {
    result = ask_callbacks(parameters);
  }
  if (!result.successful) {
    return result;
  }
  rcl_interfaces::msg::ParameterEvent event;
  for (const rclcpp::Parameter& parameter : parameters) {
    const std::string& name = parameter.get_name();
    const auto found = parameters_.find(name);
    if (found == parameters_.end()) {
      ParameterInfo& info = parameters_[name];
      info.descriptor.name = name;
      info.descriptor.dynamic_typing = true;
      info.descriptor.type = parameter.get_type();
      info.value = parameter.get_parameter_value();
      if (parameter.get_type() != PARAMETER_NOT_SET) {
        event.new_parameters.push_back(parameter.to_parameter_msg());
      }
    } else if (removed.count(name) != 0) {
      event.deleted_parameters.push_back(
          rclcpp::Parameter(name, found->second.value).to_parameter_msg());
      parameters_.erase(found);
    } else {
      found->second.descriptor.type = parameter.get_type();
      found->second.value = parameter.get_parameter_value();
      event.changed_parameters.push_back(parameter.to_parameter_msg());
    }
  }
  tell_callbacks(parameters);
  publish(std::move(event));
  return result;
}

std::vector<rclcpp::Parameter> NodeParameters::get_parameters(
    const std::vector<std::string>& names) const {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  std::vector<rclcpp::Parameter> results;
  for (const std::string& name : names) {
    results.push_back(get_parameter(name));
  }
  return results;
}

rclcpp::Parameter NodeParameters::get_parameter(const std::string& name) const {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  const auto found = parameters_.find(name);
  if (found == parameters_.end()) {
    if (allow_undeclared_) {
      return rclcpp::Parameter(name);
    }
    throw exceptions::ParameterNotDeclaredException(name);
  }
  if (found->second.value.get_type() == PARAMETER_NOT_SET &&
      !found->second.descriptor.dynamic_typing) {
    throw exceptions::ParameterUninitializedException(name);
  }
  return rclcpp::Parameter(name, found->second.value);
}

bool NodeParameters::get_parameter(const std::string& name, rclcpp::Parameter& parameter) const {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  const auto found = parameters_.find(name);
  if (found == parameters_.end() || found->second.value.get_type() == PARAMETER_NOT_SET) {
    return false;
  }
  parameter = rclcpp::Parameter(name, found->second.value);
  return true;
}

bool NodeParameters::get_parameters_by_prefix(
    const std::string& prefix, std::map<std::string, rclcpp::Parameter>& parameters) const {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  const std::string start = prefix.empty() ? prefix : prefix + ".";
  bool found = false;
  for (const auto& [name, info] : parameters_) {
    if (name.size() > start.size() && name.compare(0, start.size(), start) == 0) {
      parameters[name.substr(start.size())] = rclcpp::Parameter(name, info.value);
      found = true;
    }
  }
  return found;
}

std::vector<ParameterDescriptor> NodeParameters::describe_parameters(
    const std::vector<std::string>& names) const {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  std::vector<ParameterDescriptor> results;
  for (const std::string& name : names) {
    const auto found = parameters_.find(name);
    if (found != parameters_.end()) {
      results.push_back(found->second.descriptor);
    } else if (allow_undeclared_) {
      results.emplace_back();
      results.back().name = name;
    } else {
      throw exceptions::ParameterNotDeclaredException(name);
    }
  }
  return results;
}

std::vector<uint8_t> NodeParameters::get_parameter_types(
    const std::vector<std::string>& names) const {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  std::vector<uint8_t> results;
  for (const std::string& name : names) {
    const auto found = parameters_.find(name);
    if (found == parameters_.end() && !allow_undeclared_) {
      throw exceptions::ParameterNotDeclaredException(name);
    }
    results.push_back(found == parameters_.end() ? PARAMETER_NOT_SET
                                                 : found->second.value.get_type());
  }
  return results;
}

rcl_interfaces::msg::ListParametersResult NodeParameters::list_parameters(
    const std::vector<std::string>& prefixes, uint64_t depth) const {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  constexpr uint64_t kAll = rcl_interfaces::srv::ListParameters::Request::DEPTH_RECURSIVE;
  const auto shallow_enough = [depth](const std::string& name) {
    return depth == kAll ||
           static_cast<uint64_t>(std::count(name.begin(), name.end(), '.')) < depth;
  };
  rcl_interfaces::msg::ListParametersResult result;
  for (const auto& [name, info] : parameters_) {
    const std::string& full_name = name;
    const bool wanted =
        prefixes.empty()
            ? shallow_enough(name)
            : std::any_of(prefixes.begin(), prefixes.end(), [&](const std::string& prefix) {
                const size_t length = prefix.size() + 1;
                return full_name == prefix || (full_name.compare(0, length, prefix + ".") == 0 &&
                                               shallow_enough(full_name.substr(length)));
              });
    if (!wanted) {
      continue;
    }
    result.names.push_back(name);
    const size_t dot = name.rfind('.');
    if (dot != std::string::npos) {
      const std::string prefix = name.substr(0, dot);
      if (std::find(result.prefixes.begin(), result.prefixes.end(), prefix) ==
          result.prefixes.end()) {
        result.prefixes.push_back(prefix);
      }
    }
  }
  return result;
}

PreSetParametersCallbackHandle::SharedPtr NodeParameters::add_pre_set_parameters_callback(
    PreSetParametersCallbackType callback) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  const ChangeGuard guard(changing_);
  return add_handle(pre_set_callbacks_, std::move(callback));
}

OnSetParametersCallbackHandle::SharedPtr NodeParameters::add_on_set_parameters_callback(
    OnSetParametersCallbackType callback) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  const ChangeGuard guard(changing_);
  return add_handle(on_set_callbacks_, std::move(callback));
}

PostSetParametersCallbackHandle::SharedPtr NodeParameters::add_post_set_parameters_callback(
    PostSetParametersCallbackType callback) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  const ChangeGuard guard(changing_);
  return add_handle(post_set_callbacks_, std::move(callback));
}

void NodeParameters::remove_pre_set_parameters_callback(
    const PreSetParametersCallbackHandle* const handler) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  const ChangeGuard guard(changing_);
  remove_handle(pre_set_callbacks_, handler, "Pre set parameter callback doesn't exist");
}

void NodeParameters::remove_on_set_parameters_callback(
    const OnSetParametersCallbackHandle* const handler) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  const ChangeGuard guard(changing_);
  remove_handle(on_set_callbacks_, handler, "On set parameter callback doesn't exist");
}

void NodeParameters::remove_post_set_parameters_callback(
    const PostSetParametersCallbackHandle* const handler) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  const ChangeGuard guard(changing_);
  remove_handle(post_set_callbacks_, handler, "Post set parameter callback doesn't exist");
}

}  // namespace node_interfaces
}  // namespace rclcpp
