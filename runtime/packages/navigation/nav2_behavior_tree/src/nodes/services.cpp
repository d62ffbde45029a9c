// Nodes that call services: of costmaps, planners and localization.
#include "nav2_behavior_tree/bt_service_node.hpp"
#include "nav2_msgs/srv/clear_costmap_around_pose.hpp"
#include "nav2_msgs/srv/clear_costmap_around_robot.hpp"
#include "nav2_msgs/srv/clear_costmap_except_region.hpp"
#include "nav2_msgs/srv/clear_entire_costmap.hpp"
#include "nodes/registration.hpp"
#include "std_srvs/srv/empty.hpp"

namespace nav2_behavior_tree {
namespace {

using BT::InputPort;
namespace srv = nav2_msgs::srv;

class ClearEntireCostmap : public BtServiceNode<srv::ClearEntireCostmap> {
 public:
  using BtServiceNode::BtServiceNode;
  void on_tick() override { increment_recovery_count(); }
};

/// Clears by the distance of cells from something.
template <typename ServiceT>
class ClearByDistance : public BtServiceNode<ServiceT> {
 public:
  using BtServiceNode<ServiceT>::BtServiceNode;

  static BT::PortsList providedPorts() {
    return BtServiceNode<ServiceT>::providedBasicPorts(
        {InputPort<double>("reset_distance", 1.0, "Side of the square [m]")});
  }
  void on_tick() override {
    this->getInput("reset_distance", this->request_->reset_distance);
    this->increment_recovery_count();
  }
};

class ClearCostmapAroundPose : public ClearByDistance<srv::ClearCostmapAroundPose> {
 public:
  using ClearByDistance::ClearByDistance;

  static BT::PortsList providedPorts() {
    return ports_with(ClearByDistance::providedPorts(),
                      {InputPort<geometry_msgs::msg::PoseStamped>("pose", "Middle of the square")});
  }
  void on_tick() override {
    getInput("pose", request_->pose);
    ClearByDistance::on_tick();
  }
};

using Reinitialize = BtServiceNode<std_srvs::srv::Empty>;

const NodeLibrary clear("libnav2_clear_costmap_service_bt_node.so", [](Factory& factory) {
  factory.registerNodeType<ClearEntireCostmap>("ClearEntireCostmap");
  factory.registerNodeType<ClearByDistance<srv::ClearCostmapExceptRegion>>(
      "ClearCostmapExceptRegion");
  factory.registerNodeType<ClearByDistance<srv::ClearCostmapAroundRobot>>(
      "ClearCostmapAroundRobot");
  factory.registerNodeType<ClearCostmapAroundPose>("ClearCostmapAroundPose");
});
const NodeLibrary reinitialize("libnav2_reinitialize_global_localization_service_bt_node.so",
                               [](Factory& factory) {
                                 factory.registerNodeType<Reinitialize>(
                                     "ReinitializeGlobalLocalization");
                               });

}  // namespace
}  // namespace nav2_behavior_tree
