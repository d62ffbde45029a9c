// See scene_publisher.hpp.
#include "ros/scene_publisher.hpp"

#include <cmath>
#include <utility>

#include "mesh/read_mesh.hpp"
#include "plugins/messages.hpp"
#include "ros/scene_markers.hpp"

namespace ros2wasm_sim {
namespace {

using visualization_msgs::msg::InteractiveMarkerFeedback;

constexpr std::int64_t kFrameNs = 1'000'000'000 / 60;
constexpr std::int64_t kStatsNs = 100'000'000;
constexpr std::int64_t kAllNs = 1'000'000'000;
/// The real-time factor is the mean over this long.
constexpr std::int64_t kPaceNs = 1'000'000'000;
/// Links of a message of poses for which 60 Hz are kept; more of them come less often.
constexpr std::size_t kQuickLinks = 500;

/// Metres, and parts of a quaternion: a body at rest trembles by less.
constexpr double kStill = 1e-5;

bool is_still(const Pose& now, const Pose& before) {
  const Quaternion& a = now.orientation;
  const Quaternion& b = before.orientation;
  return length(now.position - before.position) < kStill && std::abs(a.w - b.w) < kStill &&
         std::abs(a.x - b.x) < kStill && std::abs(a.y - b.y) < kStill &&
         std::abs(a.z - b.z) < kStill;
}

Vector3 vector_of(const geometry_msgs::msg::Point& point) {
  return {point.x, point.y, point.z};
}

}  // namespace

ScenePublisher::ScenePublisher(Host& host, Simulation& simulation, Runner& runner)
    : host_(host),
      simulation_(simulation),
      runner_(runner),
      drag_(simulation, [this] { return clock_.now().nanoseconds(); }) {
  rclcpp::Node& node = *host_.node();
  const rclcpp::QoS latched = rclcpp::QoS(1).transient_local();
  using visualization_msgs::msg::MarkerArray;
  visuals_.publisher = node.create_publisher<MarkerArray>("/_gz/scene", latched);
  collisions_.publisher = node.create_publisher<MarkerArray>("/_gz/collisions", latched);
  lights_.publisher = node.create_publisher<MarkerArray>("/_gz/lights", latched);
  contacts_ = node.create_publisher<MarkerArray>("/_gz/contacts", rclcpp::QoS(5));
  poses_ = node.create_publisher<tf2_msgs::msg::TFMessage>("/_gz/poses", rclcpp::QoS(5));
  stats_ =
      node.create_publisher<gazebo_msgs::msg::PerformanceMetrics>("/_gz/stats", rclcpp::QoS(5));
  paused_ = node.create_publisher<std_msgs::msg::Bool>("/_gz/paused", latched);
  hand_ = node.create_subscription<InteractiveMarkerFeedback>(
      "/_gz/hand", rclcpp::QoS(10),
      [this](const InteractiveMarkerFeedback::SharedPtr& feedback) { take(*feedback); });
  runner_.on_tick([this] { look(); });
  runner_.before_step([this] { drag_.act(); });
}

void ScenePublisher::look() {
  const std::int64_t now_ns = clock_.now().nanoseconds();
  if (said_paused_ != runner_.paused()) {
    said_paused_ = runner_.paused();
    std_msgs::msg::Bool message;
    message.data = runner_.paused();
    paused_->publish(message);
    pace_since_ns_ = 0;
  }
  if (now_ns < next_poses_ns_) return;
  next_poses_ns_ = now_ns + kFrameNs;
  look_at_shapes();
  look_at_poses(now_ns);
  look_at_contacts();
  look_at_pace(now_ns);
}

void ScenePublisher::look_at_shapes() {
  const auto is_due = [this](Shapes& shapes) {
    if (shapes.revision == simulation_.revision() ||
        shapes.publisher->get_subscription_count() == 0)
      return false;
    shapes.revision = simulation_.revision();
    return true;
  };
  const auto publish = [&](Shapes& shapes, SceneShapes kind) {
    if (!is_due(shapes)) return;
    const rclcpp::Logger logger = host_.node()->get_logger();
    const SceneMarkers made = scene_markers(simulation_.world(), kind, site_meshes(logger));
    if (made.skipped > 0)
      RCLCPP_WARN(logger, "the view of the world leaves out %zu shapes: it draws at most 5000",
                  made.skipped);
    shapes.publisher->publish(made.message);
  };
  publish(visuals_, SceneShapes::kVisuals);
  publish(collisions_, SceneShapes::kCollisions);
  if (is_due(lights_)) lights_.publisher->publish(light_markers(simulation_.world()));
}

void ScenePublisher::refresh_links() {
  if (links_revision_ == simulation_.revision()) return;
  links_revision_ = simulation_.revision();
  links_.clear();
  for (const Model& model : simulation_.world().models)
    for (const Link& link : model.links)
      links_.push_back(
          {model.name + "::" + link.name, simulation_.physics().link(model.name, link.name), {}});
  next_all_ns_ = 0;
  refreshed_ = true;
}

void ScenePublisher::look_at_poses(std::int64_t now_ns) {
  const std::size_t viewers = poses_->get_subscription_count();
  if (viewers > viewers_) next_all_ns_ = 0;
  viewers_ = viewers;
  if (viewers == 0) return;
  refresh_links();
  const bool all = now_ns >= next_all_ns_;
  if (all) next_all_ns_ = now_ns + kAllNs;
  publish_poses(all);
}

void ScenePublisher::publish_poses(bool all) {
  const auto stamp = stamp_of(simulation_.time_ns());
  tf2_msgs::msg::TFMessage message;
  if (all) message.transforms.push_back(transform_message(stamp, "", "world", {}));
  for (Shown& shown : links_) {
    const Pose pose = simulation_.physics().pose(shown.link);
    // A link that has not moved is sent as it was, so that a viewer need not draw it again.
    const bool still = !refreshed_ && is_still(pose, shown.pose);
    if (!all && still) continue;
    if (!still) shown.pose = pose;
    message.transforms.push_back(transform_message(stamp, "world", shown.frame, shown.pose));
  }
  refreshed_ = false;
  const std::size_t moved = message.transforms.size();
  if (moved > kQuickLinks)
    next_poses_ns_ += kFrameNs * static_cast<std::int64_t>(moved / kQuickLinks);
  if (all) add_inner_frames(message);
  if (!message.transforms.empty()) poses_->publish(message);
}

/// Joints, sensors and named frames: places in links, which change with the set of models only.
void ScenePublisher::add_inner_frames(tf2_msgs::msg::TFMessage& message) const {
  const builtin_interfaces::msg::Time none;
  for (const Model& model : simulation_.world().models) {
    const auto add = [&](const std::string& link, const std::string& name, const Pose& pose) {
      message.transforms.push_back(transform_message(none, model.name + "::" + link,
                                                     model.name + "::" + link + "::" + name, pose));
    };
    for (const Joint& joint : model.joints)
      if (joint.type != JointType::kFixed) add(joint.child, joint.name, joint.pose);
    for (const Frame& frame : model.frames) add(frame.link, frame.name, frame.pose);
    for (const Link& link : model.links)
      for (const Sensor& sensor : link.sensors) add(link.name, sensor.name, sensor.pose);
  }
}

void ScenePublisher::look_at_contacts() {
  if (contacts_->get_subscription_count() == 0) {
    contacts_of_ns_ = -1;
    return;
  }
  if (!watches_contacts_) {
    watches_contacts_ = true;
    simulation_.physics().watch_contacts();
  }
  if (contacts_of_ns_ == simulation_.time_ns()) return;
  contacts_of_ns_ = simulation_.time_ns();
  contacts_->publish(contact_markers(simulation_.physics().contacts()));
}

void ScenePublisher::look_at_pace(std::int64_t now_ns) {
  if (now_ns < next_stats_ns_ || stats_->get_subscription_count() == 0) return;
  next_stats_ns_ = now_ns + kStatsNs;
  const std::int64_t time_ns = simulation_.time_ns();
  if (pace_since_ns_ == 0 || now_ns - pace_since_ns_ > 2 * kPaceNs || time_ns < pace_from_ns_) {
    pace_since_ns_ = now_ns;
    pace_from_ns_ = time_ns;
  }
  gazebo_msgs::msg::PerformanceMetrics message;
  message.header.stamp = stamp_of(time_ns);
  const std::int64_t passed = now_ns - pace_since_ns_;
  if (passed > 0)
    message.real_time_factor =
        static_cast<double>(time_ns - pace_from_ns_) / static_cast<double>(passed);
  if (passed > kPaceNs) {
    pace_since_ns_ = now_ns;
    pace_from_ns_ = time_ns;
  }
  stats_->publish(message);
}

void ScenePublisher::take(const InteractiveMarkerFeedback& feedback) {
  const std::string& name = feedback.marker_name;
  const std::size_t colons = name.find("::");
  const std::string model = name.substr(0, colons);
  const std::string link = colons == std::string::npos ? "" : name.substr(colons + 2);
  const Vector3 point = vector_of(feedback.pose.position);
  const Vector3 target = vector_of(feedback.mouse_point);
  if (!std::isfinite(length(point)) || !std::isfinite(length(target))) return;
  switch (feedback.event_type) {
    case InteractiveMarkerFeedback::POSE_UPDATE:
      drag_.hold(model, link, point, target);
      break;
    case InteractiveMarkerFeedback::MOUSE_UP:
      drag_.release();
      break;
    case InteractiveMarkerFeedback::BUTTON_CLICK:
      drag_.push(model, link, point, target);
      break;
    default:
      break;
  }
}

}  // namespace ros2wasm_sim
