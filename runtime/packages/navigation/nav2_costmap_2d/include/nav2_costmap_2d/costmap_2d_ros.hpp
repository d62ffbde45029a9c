// The node of a costmap: it loads layers, updates them in a thread of its own, and publishes the
// costs. A server owns one as a child node, and leads it through its states.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "geometry_msgs/msg/polygon.hpp"
#include "geometry_msgs/msg/polygon_stamped.hpp"
#include "nav2_costmap_2d/clear_costmap_service.hpp"
#include "nav2_costmap_2d/costmap_2d_publisher.hpp"
#include "nav2_costmap_2d/footprint.hpp"
#include "nav2_costmap_2d/footprint_collision_checker.hpp"
#include "nav2_costmap_2d/layer.hpp"
#include "nav2_costmap_2d/layered_costmap.hpp"
#include "nav2_msgs/srv/get_cost.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "pluginlib/class_loader.hpp"
#include "tf2/LinearMath/Transform.h"
#include "tf2/convert.h"
#include "tf2/time.h"
#include "tf2/transform_datatypes.h"
#include "tf2/utils.h"
#include "tf2_ros/buffer.h"
#include "tf2_ros/transform_listener.h"

namespace nav2_costmap_2d {

class Costmap2DROS : public nav2_util::LifecycleNode {
 public:
  /// A node by itself, named `costmap`.
  explicit Costmap2DROS(const rclcpp::NodeOptions& options = rclcpp::NodeOptions());
  /// A child of a server, in the namespace of its name.
  explicit Costmap2DROS(const std::string& name, const bool& use_sim_time = false);
  explicit Costmap2DROS(const std::string& name, const std::string& parent_namespace,
                        const std::string& local_namespace, const bool& use_sim_time);
  ~Costmap2DROS();

  void init();
  nav2_util::CallbackReturn on_configure(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_activate(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_deactivate(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_cleanup(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_shutdown(const rclcpp_lifecycle::State& state) override;
  /// Nothing for a child: its server leads it.
  void on_rcl_preshutdown() override;

  /// Activates the layers and waits for the first round.
  void start();
  void stop();
  void pause();
  void resume();
  /// One round.
  void updateMap();
  void resetLayers();
  bool isCurrent() { return layered_costmap_->isCurrent(); }

  bool getRobotPose(geometry_msgs::msg::PoseStamped& global_pose);
  bool transformPoseToGlobalFrame(const geometry_msgs::msg::PoseStamped& input_pose,
                                  geometry_msgs::msg::PoseStamped& transformed_pose);
  std::string getName() const { return name_; }
  double getTransformTolerance() const { return transform_tolerance_; }
  Costmap2D* getCostmap() { return layered_costmap_->getCostmap(); }
  std::string getGlobalFrameID() { return global_frame_; }
  std::string getBaseFrameID() { return robot_base_frame_; }
  LayeredCostmap* getLayeredCostmap() { return layered_costmap_.get(); }
  geometry_msgs::msg::Polygon getRobotFootprintPolygon() { return toPolygon(getRobotFootprint()); }
  std::vector<geometry_msgs::msg::Point> getRobotFootprint() {
    const std::lock_guard<std::mutex> lock(footprint_mutex_);
    return padded_footprint_;
  }
  std::vector<geometry_msgs::msg::Point> getUnpaddedRobotFootprint() {
    const std::lock_guard<std::mutex> lock(footprint_mutex_);
    return unpadded_footprint_;
  }
  /// At the pose of the robot; unchanged when that is unknown.
  void getOrientedFootprint(std::vector<geometry_msgs::msg::Point>& oriented_footprint);
  /// Refuses one that is empty, or whose numbers are not finite.
  void setRobotFootprint(const std::vector<geometry_msgs::msg::Point>& points);
  void setRobotFootprintPolygon(const geometry_msgs::msg::Polygon::SharedPtr footprint);
  std::shared_ptr<tf2_ros::Buffer> getTfBuffer() { return tf_buffer_; }
  bool getUseRadius() { return use_radius_; }
  double getRobotRadius() { return robot_radius_; }
  void getCostCallback(const std::shared_ptr<rmw_request_id_t>,
                       const std::shared_ptr<nav2_msgs::srv::GetCost::Request> request,
                       const std::shared_ptr<nav2_msgs::srv::GetCost::Response> response);

 protected:
  void getParameters();
  void mapUpdateLoop(double frequency);
  rcl_interfaces::msg::SetParametersResult dynamicParametersCallback(
      std::vector<rclcpp::Parameter> parameters);

  rclcpp_lifecycle::LifecyclePublisher<geometry_msgs::msg::PolygonStamped>::SharedPtr
      footprint_pub_;
  std::unique_ptr<Costmap2DPublisher> costmap_publisher_;
  std::vector<std::unique_ptr<Costmap2DPublisher>> layer_publishers_;
  rclcpp::Subscription<geometry_msgs::msg::Polygon>::SharedPtr footprint_sub_;
  // Clouds and transforms arrive in a thread of their own, while a round may take long.
  rclcpp::CallbackGroup::SharedPtr callback_group_;
  rclcpp::executors::SingleThreadedExecutor::SharedPtr executor_;
  std::unique_ptr<nav2_util::NodeThread> executor_thread_;
  std::shared_ptr<tf2_ros::Buffer> tf_buffer_;
  std::shared_ptr<tf2_ros::TransformListener> tf_listener_;
  // Before the layers, whose code it has.
  pluginlib::ClassLoader<Layer> plugin_loader_{"nav2_costmap_2d", "nav2_costmap_2d::Layer"};
  std::unique_ptr<LayeredCostmap> layered_costmap_;
  std::string name_;
  std::string parent_namespace_;

  std::atomic<bool> map_update_thread_shutdown_{false};
  std::atomic<bool> stop_updates_{false};
  std::atomic<bool> initialized_{false};
  std::atomic<bool> stopped_{true};
  std::mutex dynamic_parameter_mutex_;
  std::unique_ptr<std::thread> map_update_thread_;
  rclcpp::Time last_publish_{0, 0, RCL_ROS_TIME};
  rclcpp::Duration publish_cycle_{1, 0};

  bool always_send_full_costmap_ = false;
  std::string footprint_;
  double footprint_padding_ = 0.0;
  std::string global_frame_;
  int map_height_meters_ = 0;
  double map_publish_frequency_ = 0.0;
  double map_update_frequency_ = 0.0;
  int map_width_meters_ = 0;
  double origin_x_ = 0.0;
  double origin_y_ = 0.0;
  std::vector<std::string> default_plugins_{"static_layer", "obstacle_layer", "inflation_layer"};
  std::vector<std::string> default_types_{"nav2_costmap_2d::StaticLayer",
                                          "nav2_costmap_2d::ObstacleLayer",
                                          "nav2_costmap_2d::InflationLayer"};
  std::vector<std::string> plugin_names_;
  std::vector<std::string> filter_names_;
  double resolution_ = 0.0;
  std::string robot_base_frame_;
  double robot_radius_ = 0.0;
  bool rolling_window_ = false;
  bool track_unknown_space_ = false;
  double transform_tolerance_ = 0.0;
  double initial_transform_timeout_ = 0.0;
  double map_vis_z_ = 0.0;
  bool is_lifecycle_follower_ = true;
  bool use_radius_ = false;
  std::mutex footprint_mutex_;  // of the two below
  std::vector<geometry_msgs::msg::Point> unpadded_footprint_;
  std::vector<geometry_msgs::msg::Point> padded_footprint_;

  rclcpp::Service<nav2_msgs::srv::GetCost>::SharedPtr get_cost_service_;
  std::unique_ptr<ClearCostmapService> clear_costmap_service_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr dyn_params_handler_;

 private:
  void loadLayers();
  std::shared_ptr<Layer> loadLayer(const std::string& name);
  void makePublishers();
  bool waitForTransform();
  void publishCosts();
  void resizeToParameters();
  std::vector<std::shared_ptr<Layer>> layersAndFilters();
  std::string applyParameter(const rclcpp::Parameter& parameter, bool& resized);
};

}  // namespace nav2_costmap_2d
