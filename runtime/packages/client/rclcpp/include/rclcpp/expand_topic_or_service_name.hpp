// The full name of a topic or service, before remapping.
#pragma once

#include <string>

#include "rclcpp/visibility_control.hpp"

namespace rclcpp {

/// Throws InvalidTopicNameError or InvalidServiceNameError, InvalidNodeNameError or
/// InvalidNamespaceError for what cannot be.
std::string expand_topic_or_service_name(const std::string& name, const std::string& node_name,
                                         const std::string& namespace_, bool is_service = false);

}  // namespace rclcpp
