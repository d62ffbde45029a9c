// RCLCPP_COMPONENTS_REGISTER_NODE(ns::Class), at the end of a component's source file.
#pragma once

#include "class_loader/class_loader.hpp"
#include "rclcpp_components/node_factory_template.hpp"

#define RCLCPP_COMPONENTS_REGISTER_NODE(NodeClass)                               \
  CLASS_LOADER_REGISTER_CLASS(rclcpp_components::NodeFactoryTemplate<NodeClass>, \
                              rclcpp_components::NodeFactory)
