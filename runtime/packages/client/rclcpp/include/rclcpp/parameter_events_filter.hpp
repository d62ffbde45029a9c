// Picks parameters and kinds of change out of a parameter event.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rcl_interfaces/msg/parameter_event.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp {

class ParameterEventsFilter {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterEventsFilter)
  enum class EventType { NEW, DELETED, CHANGED };
  using EventPair = std::pair<EventType, const rcl_interfaces::msg::Parameter*>;

  ParameterEventsFilter(std::shared_ptr<const rcl_interfaces::msg::ParameterEvent> event,
                        const std::vector<std::string>& names, const std::vector<EventType>& types);
  const std::vector<EventPair>& get_events() const { return result_; }

 private:
  std::vector<EventPair> result_;
  std::shared_ptr<const rcl_interfaces::msg::ParameterEvent> event_;
};

}  // namespace rclcpp
