// See publisher.hpp.
#include "dwb_core/publisher.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "nav2_util/node_utils.hpp"
#include "nav_2d_utils/conversions.hpp"
#include "sensor_msgs/msg/point_field.hpp"

namespace dwb_core {

using dwb_msgs::msg::LocalPlanEvaluation;
using nav2_util::CallbackReturn;
using sensor_msgs::msg::PointCloud2;
using visualization_msgs::msg::Marker;
using visualization_msgs::msg::MarkerArray;

namespace {

/// The values of all cells, by name.
using Channels = std::vector<std::pair<std::string, std::vector<float>>>;

/// Green for the best, red for the worst, black for a forbidden one.
void paint(Marker& marker, double total, double best, double worst) {
  const double range = std::abs(worst - best) < 1e-9 ? 1.0 : worst - best;
  const double level = (total - best) / range;
  const bool is_valid = total >= 0;
  marker.ns = is_valid ? "ValidTrajectories" : "InvalidTrajectories";
  marker.color.r = static_cast<float>(is_valid ? level : 0.0);
  marker.color.g = static_cast<float>(is_valid ? 1.0 - level : 0.0);
  marker.color.b = 0.0F;
  marker.color.a = 1.0F;
}

/// One channel per critic that has one, and `total_cost`, the sum of those times their scales.
Channels channels_of(const std::vector<TrajectoryCritic::Ptr>& critics, size_t cells) {
  Channels channels;
  std::vector<float> total(cells, 0.0F);
  for (const TrajectoryCritic::Ptr& critic : critics) {
    const size_t index = channels.size();
    critic->addCriticVisualization(channels);
    if (channels.size() == index) continue;
    for (size_t i = index; i < channels.size(); ++i) channels[i].second.resize(cells);
    const auto scale = static_cast<float>(critic->getScale());
    for (size_t i = 0; i < cells; ++i) total[i] += channels[index].second[i] * scale;
  }
  channels.emplace_back("total_cost", std::move(total));
  return channels;
}

/// A point at the centre of each cell, with x, y, z and the channels.
void fill(PointCloud2& cloud, const nav2_costmap_2d::Costmap2D& costmap, const Channels& channels) {
  std::vector<std::string> names{"x", "y", "z"};
  for (const auto& channel : channels) names.push_back(channel.first);
  for (const std::string& name : names) {
    sensor_msgs::msg::PointField field;
    field.name = name;
    field.offset = static_cast<uint32_t>(cloud.fields.size() * sizeof(float));
    field.datatype = sensor_msgs::msg::PointField::FLOAT32;
    field.count = 1;
    cloud.fields.push_back(field);
  }
  const unsigned int size_x = costmap.getSizeInCellsX();
  cloud.width = size_x * costmap.getSizeInCellsY();
  cloud.height = 1;
  cloud.is_dense = true;
  cloud.is_bigendian = false;
  cloud.point_step = static_cast<uint32_t>(names.size() * sizeof(float));
  cloud.row_step = cloud.point_step * cloud.width;
  std::vector<float> values;
  values.reserve(names.size() * cloud.width);
  for (unsigned int cell = 0; cell < cloud.width; ++cell) {
    double x = 0.0;
    double y = 0.0;
    costmap.mapToWorld(cell % size_x, cell / size_x, x, y);
    values.insert(values.end(), {static_cast<float>(x), static_cast<float>(y), 0.0F});
    for (const auto& channel : channels) values.push_back(channel.second[cell]);
  }
  cloud.data.resize(values.size() * sizeof(float));
  std::memcpy(cloud.data.data(), values.data(), cloud.data.size());
}

}  // namespace

DWBPublisher::DWBPublisher(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                           const std::string& plugin_name)
    : node_(parent), clock_(parent.lock()->get_clock()), plugin_name_(plugin_name) {}

CallbackReturn DWBPublisher::on_configure() {
  const auto node = node_.lock();
  if (!node) throw std::runtime_error{"Failed to lock node"};
  const auto read = [&](const char* name, auto& value) {
    const std::string full = plugin_name_ + "." + name;
    nav2_util::declare_parameter_if_not_declared(node, full, rclcpp::ParameterValue(value));
    node->get_parameter(full, value);
  };
  double marker_lifetime = 0.1;
  read("publish_evaluation", publish_evaluation_);
  read("publish_global_plan", publish_global_plan_);
  read("publish_transformed_plan", publish_transformed_);
  read("publish_local_plan", publish_local_plan_);
  read("publish_trajectories", publish_trajectories_);
  read("publish_cost_grid_pc", publish_cost_grid_pc_);
  read("marker_lifetime", marker_lifetime);
  marker_lifetime_ = rclcpp::Duration::from_seconds(marker_lifetime);

  eval_pub_ = node->create_publisher<LocalPlanEvaluation>("evaluation", 1);
  global_pub_ = node->create_publisher<nav_msgs::msg::Path>("received_global_plan", 1);
  transformed_pub_ = node->create_publisher<nav_msgs::msg::Path>("transformed_global_plan", 1);
  local_pub_ = node->create_publisher<nav_msgs::msg::Path>("local_plan", 1);
  marker_pub_ = node->create_publisher<MarkerArray>("marker", 1);
  cost_grid_pc_pub_ = node->create_publisher<PointCloud2>("cost_cloud", 1);
  return CallbackReturn::SUCCESS;
}

std::vector<rclcpp_lifecycle::ManagedEntityInterface*> DWBPublisher::entities() {
  return {eval_pub_.get(),  global_pub_.get(), transformed_pub_.get(),
          local_pub_.get(), marker_pub_.get(), cost_grid_pc_pub_.get()};
}

CallbackReturn DWBPublisher::on_activate() {
  for (auto* const one : entities()) one->on_activate();
  return CallbackReturn::SUCCESS;
}

CallbackReturn DWBPublisher::on_deactivate() {
  for (auto* const one : entities()) one->on_deactivate();
  return CallbackReturn::SUCCESS;
}

CallbackReturn DWBPublisher::on_cleanup() {
  eval_pub_.reset();
  global_pub_.reset();
  transformed_pub_.reset();
  local_pub_.reset();
  marker_pub_.reset();
  cost_grid_pc_pub_.reset();
  return CallbackReturn::SUCCESS;
}

bool DWBPublisher::shouldRecordEvaluation() {
  return (publish_evaluation_ && eval_pub_->get_subscription_count() > 0) ||
         (publish_trajectories_ && marker_pub_->get_subscription_count() > 0);
}

void DWBPublisher::publishEvaluation(std::shared_ptr<LocalPlanEvaluation> results) {
  if (!results) return;
  if (publish_evaluation_ && eval_pub_->get_subscription_count() > 0) eval_pub_->publish(*results);
  publishTrajectories(*results);
}

void DWBPublisher::publishTrajectories(const LocalPlanEvaluation& results) {
  if (!publish_trajectories_ || marker_pub_->get_subscription_count() < 1) return;
  if (results.twists.empty()) return;
  MarkerArray markers;
  Marker marker;
  marker.header = results.header;
  marker.type = Marker::LINE_STRIP;
  marker.pose.orientation.w = 1;
  marker.scale.x = 0.002;
  marker.lifetime = marker_lifetime_;
  const double best = results.twists.at(results.best_index).total;
  const double worst = results.twists.at(results.worst_index).total;
  int valid = 0;
  int invalid = 0;
  for (const auto& twist : results.twists) {
    paint(marker, twist.total, best, worst);
    marker.id = twist.total >= 0 ? valid++ : invalid++;
    marker.points.resize(twist.traj.poses.size());
    for (size_t i = 0; i < marker.points.size(); ++i) {
      marker.points[i].x = twist.traj.poses[i].x;
      marker.points[i].y = twist.traj.poses[i].y;
    }
    markers.markers.push_back(marker);
  }
  marker_pub_->publish(markers);
}

void DWBPublisher::publishLocalPlan(const std_msgs::msg::Header& header,
                                    const dwb_msgs::msg::Trajectory2D& traj) {
  if (!publish_local_plan_ || local_pub_->get_subscription_count() < 1) return;
  local_pub_->publish(nav_2d_utils::poses2DToPath(traj.poses, header.frame_id, header.stamp));
}

void DWBPublisher::publishCostGrid(const std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros,
                                   const std::vector<TrajectoryCritic::Ptr> critics) {
  if (!publish_cost_grid_pc_ || cost_grid_pc_pub_->get_subscription_count() < 1) return;
  nav2_costmap_2d::Costmap2D* const costmap = costmap_ros->getCostmap();
  const std::lock_guard<nav2_costmap_2d::Costmap2D::mutex_t> lock(*costmap->getMutex());
  PointCloud2 cloud;
  cloud.header.frame_id = costmap_ros->getGlobalFrameID();
  cloud.header.stamp = clock_->now();
  const size_t cells = size_t{costmap->getSizeInCellsX()} * costmap->getSizeInCellsY();
  fill(cloud, *costmap, channels_of(critics, cells));
  cost_grid_pc_pub_->publish(cloud);
}

void DWBPublisher::publishGlobalPlan(const nav_2d_msgs::msg::Path2D plan) {
  publishGenericPlan(plan, *global_pub_, publish_global_plan_);
}

void DWBPublisher::publishTransformedPlan(const nav_2d_msgs::msg::Path2D plan) {
  publishGenericPlan(plan, *transformed_pub_, publish_transformed_);
}

void DWBPublisher::publishLocalPlan(const nav_2d_msgs::msg::Path2D plan) {
  publishGenericPlan(plan, *local_pub_, publish_local_plan_);
}

void DWBPublisher::publishGenericPlan(const nav_2d_msgs::msg::Path2D plan,
                                      rclcpp::Publisher<nav_msgs::msg::Path>& pub, bool flag) {
  if (flag && pub.get_subscription_count() > 0) pub.publish(nav_2d_utils::pathToPath(plan));
}

}  // namespace dwb_core
