// Handing parameter events to those who asked for them.
#include "rclcpp/parameter_event_handler.hpp"

#include <algorithm>
#include <stdexcept>

#include "rclcpp/parameter_events_filter.hpp"

namespace rclcpp {

using rcl_interfaces::msg::ParameterEvent;

ParameterEventCallbackHandle::SharedPtr ParameterEventHandler::add_parameter_event_callback(
    ParameterEventCallbackType callback) {
  const std::lock_guard<std::recursive_mutex> lock(callbacks_->mutex_);
  auto handle = std::make_shared<ParameterEventCallbackHandle>();
  handle->callback = std::move(callback);
  callbacks_->event_callbacks_.emplace_front(handle);
  return handle;
}

void ParameterEventHandler::remove_parameter_event_callback(
    ParameterEventCallbackHandle::SharedPtr callback_handle) {
  const std::lock_guard<std::recursive_mutex> lock(callbacks_->mutex_);
  auto& all = callbacks_->event_callbacks_;
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const auto& weak) { return weak.lock() == callback_handle; });
  if (found == all.end()) {
    throw std::runtime_error("Callback doesn't exist");
  }
  all.erase(found);
}

ParameterCallbackHandle::SharedPtr ParameterEventHandler::add_parameter_callback(
    const std::string& parameter_name, ParameterCallbackType callback,
    const std::string& node_name) {
  const std::lock_guard<std::recursive_mutex> lock(callbacks_->mutex_);
  auto handle = std::make_shared<ParameterCallbackHandle>();
  handle->callback = std::move(callback);
  handle->parameter_name = parameter_name;
  handle->node_name = resolve_path(node_name);
  callbacks_->parameter_callbacks_[{parameter_name, handle->node_name}].emplace_front(handle);
  return handle;
}

void ParameterEventHandler::remove_parameter_callback(
    ParameterCallbackHandle::SharedPtr callback_handle) {
  const std::lock_guard<std::recursive_mutex> lock(callbacks_->mutex_);
  auto& container =
      callbacks_
          ->parameter_callbacks_[{callback_handle->parameter_name, callback_handle->node_name}];
  const auto found = std::find_if(container.begin(), container.end(),
                                  [&](const auto& weak) { return weak.lock() == callback_handle; });
  if (found == container.end()) {
    throw std::runtime_error("Callback doesn't exist");
  }
  container.erase(found);
}

bool ParameterEventHandler::get_parameter_from_event(const ParameterEvent& event,
                                                     rclcpp::Parameter& parameter,
                                                     const std::string& parameter_name,
                                                     const std::string& node_name) {
  if (event.node != node_name) {
    return false;
  }
  for (const auto* messages : {&event.new_parameters, &event.changed_parameters}) {
    for (const auto& message : *messages) {
      if (message.name == parameter_name) {
        parameter = rclcpp::Parameter::from_parameter_msg(message);
        return true;
      }
    }
  }
  return false;
}

rclcpp::Parameter ParameterEventHandler::get_parameter_from_event(const ParameterEvent& event,
                                                                  const std::string& parameter_name,
                                                                  const std::string& node_name) {
  rclcpp::Parameter parameter;
  if (!get_parameter_from_event(event, parameter, parameter_name, node_name)) {
    if (event.node == node_name) {
      throw std::runtime_error("Parameter '" + parameter_name + "' of node '" + node_name +
                               "' is not part of parameter event");
    }
    throw std::runtime_error("The node name '" + node_name + "' of parameter '" + parameter_name +
                             "' doesn't match the node name '" + event.node +
                             "' in parameter event");
  }
  return parameter;
}

std::vector<rclcpp::Parameter> ParameterEventHandler::get_parameters_from_event(
    const ParameterEvent& event) {
  std::vector<rclcpp::Parameter> parameters;
  for (const auto* messages : {&event.new_parameters, &event.changed_parameters}) {
    for (const auto& message : *messages) {
      parameters.push_back(rclcpp::Parameter::from_parameter_msg(message));
    }
  }
  return parameters;
}

void ParameterEventHandler::Callbacks::event_callback(const ParameterEvent& event) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  for (auto& [key, handles] : parameter_callbacks_) {
    rclcpp::Parameter parameter;
    if (!get_parameter_from_event(event, parameter, key.first, key.second)) {
      continue;
    }
    for (auto it = handles.begin(); it != handles.end();) {
      if (const auto handle = it->lock()) {
        handle->callback(parameter);
        ++it;
      } else {
        it = handles.erase(it);
      }
    }
  }
  for (auto it = event_callbacks_.begin(); it != event_callbacks_.end();) {
    if (const auto handle = it->lock()) {
      handle->callback(event);
      ++it;
    } else {
      it = event_callbacks_.erase(it);
    }
  }
}

std::string ParameterEventHandler::resolve_path(const std::string& path) {
  if (path.empty()) {
    return node_base_->get_fully_qualified_name();
  }
  if (path[0] == '/') {
    return path;
  }
  const std::string ns = node_base_->get_namespace();
  return ns == "/" ? ns + path : ns + "/" + path;
}

ParameterEventsFilter::ParameterEventsFilter(std::shared_ptr<const ParameterEvent> event,
                                             const std::vector<std::string>& names,
                                             const std::vector<EventType>& types)
    : event_(std::move(event)) {
  const auto add = [&](EventType type, const auto& messages) {
    if (std::find(types.begin(), types.end(), type) == types.end()) {
      return;
    }
    for (const auto& message : messages) {
      if (std::find(names.begin(), names.end(), message.name) != names.end()) {
        result_.emplace_back(type, &message);
      }
    }
  };
  add(EventType::NEW, event_->new_parameters);
  add(EventType::CHANGED, event_->changed_parameters);
  add(EventType::DELETED, event_->deleted_parameters);
}

}  // namespace rclcpp
