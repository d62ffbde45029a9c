// See layer.hpp.
#include "nav2_costmap_2d/layer.hpp"

#include <stdexcept>
#include <utility>

#include "nav2_util/node_utils.hpp"

namespace nav2_costmap_2d {
namespace {

rclcpp_lifecycle::LifecycleNode::SharedPtr locked(
    const rclcpp_lifecycle::LifecycleNode::WeakPtr& node) {
  const auto alive = node.lock();
  if (!alive) throw std::runtime_error{"Failed to lock node"};
  return alive;
}

}  // namespace

Layer::Layer()
    : layered_costmap_(nullptr), name_(), tf_(nullptr), current_(false), enabled_(false) {}

void Layer::initialize(LayeredCostmap* parent, std::string name, tf2_ros::Buffer* tf,
                       const nav2_util::LifecycleNode::WeakPtr& node,
                       rclcpp::CallbackGroup::SharedPtr callback_group) {
  layered_costmap_ = parent;
  name_ = std::move(name);
  tf_ = tf;
  node_ = node;
  callback_group_ = std::move(callback_group);
  const auto alive = locked(node_);
  logger_ = alive->get_logger();
  clock_ = alive->get_clock();
  onInitialize();
}

const std::vector<geometry_msgs::msg::Point>& Layer::getFootprint() const {
  return layered_costmap_->getFootprint();
}

void Layer::declareParameter(const std::string& param_name, const rclcpp::ParameterValue& value) {
  local_params_.insert(param_name);
  nav2_util::declare_parameter_if_not_declared(locked(node_), getFullName(param_name), value);
}

void Layer::declareParameter(const std::string& param_name,
                             const rclcpp::ParameterType& param_type) {
  local_params_.insert(param_name);
  nav2_util::declare_parameter_if_not_declared(locked(node_), getFullName(param_name), param_type);
}

bool Layer::hasParameter(const std::string& param_name) {
  return locked(node_)->has_parameter(getFullName(param_name));
}

std::string Layer::getFullName(const std::string& param_name) {
  return name_ + "." + param_name;
}

}  // namespace nav2_costmap_2d
