// A costmap that another node publishes, with its changes.
#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "nav2_costmap_2d/costmap_2d.hpp"
#include "nav2_msgs/msg/costmap.hpp"
#include "nav2_msgs/msg/costmap_update.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "rclcpp/rclcpp.hpp"

namespace nav2_costmap_2d {

class CostmapSubscriber {
 public:
  /// `topic_name` of messages nav2_msgs/Costmap, such as `global_costmap/costmap_raw`.
  CostmapSubscriber(const nav2_util::LifecycleNode::WeakPtr& parent, const std::string& topic_name);
  CostmapSubscriber(const rclcpp::Node::WeakPtr& parent, const std::string& topic_name);
  ~CostmapSubscriber() {}

  /// Throws std::runtime_error before the first message.
  std::shared_ptr<Costmap2D> getCostmap();
  void costmapCallback(const nav2_msgs::msg::Costmap::SharedPtr msg);
  void costmapUpdateCallback(const nav2_msgs::msg::CostmapUpdate::SharedPtr update_msg);

 protected:
  bool isCostmapReceived();

  rclcpp::Subscription<nav2_msgs::msg::Costmap>::SharedPtr costmap_sub_;
  rclcpp::Subscription<nav2_msgs::msg::CostmapUpdate>::SharedPtr costmap_update_sub_;
  std::shared_ptr<Costmap2D> costmap_;
  nav2_msgs::msg::Costmap::SharedPtr costmap_msg_;  // not yet copied
  std::string topic_name_;
  std::mutex costmap_msg_mutex_;
  rclcpp::Logger logger_{rclcpp::get_logger("nav2_costmap_2d")};

 private:
  template <typename NodeT>
  void subscribe(const NodeT& node);
};

}  // namespace nav2_costmap_2d
