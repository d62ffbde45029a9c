// See slam_toolbox_common.hpp. The map, and sessions in files.
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "core/session_file.hpp"
#include "nav2_map_server/map_io.hpp"
#include "node/slam_toolbox_common.hpp"

namespace slam_toolbox {
namespace {

using srv::DeserializePoseGraph;

constexpr const char* kEnding = ".posegraph";

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("the file cannot be opened");
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace

void SlamToolbox::draw() {
  const std::vector<Scan>& scans = mapper_->scans();
  if (drawn_revision_ != mapper_->revision()) {
    coverage_->clear();
    drawn_scans_ = 0;
    drawn_revision_ = mapper_->revision();
  }
  for (; drawn_scans_ < scans.size(); ++drawn_scans_) {
    if (coverage_->add(scans[drawn_scans_]) || is_too_large_) continue;
    is_too_large_ = true;
    RCLCPP_ERROR(get_logger(),
                 "The map would have more than 20 million cells, so scans are missing in it. Set a "
                 "smaller max_laser_range or a larger resolution.");
  }
}

nav_msgs::msg::OccupancyGrid SlamToolbox::map_message() {
  draw();
  OccupancyCells cells = coverage_->cells();
  nav_msgs::msg::OccupancyGrid map;
  map.header.frame_id = parameters_.map_frame;
  map.header.stamp = scan_stamp_;
  map.info.resolution = static_cast<float>(parameters_.resolution);
  map.info.width = static_cast<uint32_t>(cells.columns);
  map.info.height = static_cast<uint32_t>(cells.rows);
  map.info.origin.position.x = cells.origin.x;
  map.info.origin.position.y = cells.origin.y;
  map.info.origin.orientation.w = 1.0;
  map.data = std::move(cells.values);
  return map;
}

void SlamToolbox::publish_map() {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  if (!is_active_) return;
  const size_t listeners = map_publisher_->get_subscription_count();
  const bool is_new = published_scans_ != mapper_->scans().size() ||
                      published_revision_ != mapper_->revision() || listeners > map_listeners_;
  map_listeners_ = listeners;
  if (mapper_->scans().empty() || listeners == 0 || !is_new) return;
  published_scans_ = mapper_->scans().size();
  published_revision_ = mapper_->revision();
  auto map = std::make_unique<nav_msgs::msg::OccupancyGrid>(map_message());
  metadata_publisher_->publish(map->info);
  map_publisher_->publish(std::move(map));
}

void SlamToolbox::publish_graph() {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  if (mapper_->scans().empty() || graph_publisher_->get_subscription_count() == 0) return;
  visualization_msgs::msg::MarkerArray markers;
  visualization_msgs::msg::Marker points;
  points.header.frame_id = parameters_.map_frame;
  points.header.stamp = now();
  points.ns = "slam_toolbox";
  points.pose.orientation.w = 1.0;
  points.color.a = 1.0F;
  visualization_msgs::msg::Marker lines = points;
  points.type = visualization_msgs::msg::Marker::SPHERE_LIST;
  points.scale.x = points.scale.y = points.scale.z = 0.1;
  points.color.r = 1.0F;
  lines.id = 1;
  lines.type = visualization_msgs::msg::Marker::LINE_LIST;
  lines.scale.x = 0.02;
  lines.color.b = 1.0F;
  const auto point_of = [this](int index) {
    const Pose& pose = mapper_->scans()[static_cast<size_t>(index)].corrected;
    geometry_msgs::msg::Point point;
    point.x = pose.x;
    point.y = pose.y;
    return point;
  };
  for (size_t i = 0; i < mapper_->scans().size(); ++i) {
    points.points.push_back(point_of(static_cast<int>(i)));
  }
  for (const Edge& edge : mapper_->graph().edges()) {
    lines.points.push_back(point_of(edge.from));
    lines.points.push_back(point_of(edge.to));
  }
  markers.markers = {points, lines};
  graph_publisher_->publish(markers);
}

void SlamToolbox::save_map(const srv::SaveMap::Request& request, srv::SaveMap::Response& response) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  if (mapper_->scans().empty()) {
    RCLCPP_WARN(get_logger(), "Map Saver: Cannot save map, no map yet received on topic %s.",
                parameters_.map_name.c_str());
    response.result = srv::SaveMap::Response::RESULT_NO_MAP_RECEIEVD;
    return;
  }
  nav2_map_server::SaveParameters file;
  file.map_file_name = request.name.data;
  // Those of map_saver_cli.
  file.free_thresh = 0.25;
  file.occupied_thresh = 0.65;
  if (file.map_file_name.empty()) {
    RCLCPP_INFO(get_logger(), "SlamToolbox: Saving map in current directory.");
  } else {
    RCLCPP_INFO(get_logger(), "SlamToolbox: Saving map as %s.", file.map_file_name.c_str());
  }
  response.result = nav2_map_server::saveMapToFile(map_message(), file)
                        ? srv::SaveMap::Response::RESULT_SUCCESS
                        : srv::SaveMap::Response::RESULT_UNDEFINED_FAILURE;
}

void SlamToolbox::set_paused(bool is_paused) {
  is_paused_ = is_paused;
  set_parameter({"paused_new_measurements", is_paused});
}

void SlamToolbox::pause(srv::Pause::Response& response) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  set_paused(!is_paused_);
  RCLCPP_INFO(get_logger(), "SlamToolbox: Toggled to %s",
              is_paused_ ? "pause taking new measurements." : "actively taking new measurements.");
  response.status = true;
}

void SlamToolbox::reset_map(const srv::Reset::Request& request, srv::Reset::Response& response) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  drop_taken();
  forget();
  if (request.pause_new_measurements) {
    set_paused(true);
    RCLCPP_INFO(get_logger(), "SlamToolbox: Toggled to pause taking new measurements after reset.");
  }
  response.result = srv::Reset::Response::RESULT_SUCCESS;
}

void SlamToolbox::serialize(const srv::SerializePoseGraph::Request& request,
                            srv::SerializePoseGraph::Response& response) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  const std::string bytes = to_bytes(mapper_->scans(), mapper_->graph().edges());
  std::ofstream file(request.filename + kEnding, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (file) {
    response.result = srv::SerializePoseGraph::Response::RESULT_SUCCESS;
    return;
  }
  RCLCPP_ERROR(get_logger(), "Failed to write file: %s%s.", request.filename.c_str(), kEnding);
  response.result = srv::SerializePoseGraph::Response::RESULT_FAILED_TO_WRITE_FILE;
}

void SlamToolbox::deserialize(const std::string& filename, int8_t match_type, const Pose& pose) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  using Request = DeserializePoseGraph::Request;
  if (match_type == Request::LOCALIZE_AT_POSE) {
    RCLCPP_WARN(get_logger(), "Requested a localization deserialization in non-localization mode.");
    return;
  }
  if (match_type != Request::START_AT_FIRST_NODE && match_type != Request::START_AT_GIVEN_POSE) {
    RCLCPP_ERROR(get_logger(),
                 "Deserialization called without valid processor type set. Undefined behavior!");
    return;
  }
  if (filename.empty()) {
    RCLCPP_WARN(get_logger(), "No map file given!");
    return;
  }
  if (!is_usable(pose)) {
    RCLCPP_ERROR(get_logger(),
                 "DeserializePoseGraph: A pose that is not finite or too far away is refused.");
    return;
  }
  try {
    Session session = session_of(content_of(filename + kEnding));
    drop_taken();
    forget();
    mapper_->restore(std::move(session.scans), session.edges);
  } catch (const std::exception& error) {
    RCLCPP_ERROR(get_logger(), "DeserializePoseGraph: Failed to read file: %s (%s).",
                 filename.c_str(), error.what());
    return;
  }
  start_ = match_type == Request::START_AT_FIRST_NODE ? Start::kFirstScan : Start::kGivenPose;
  start_pose_ = pose;
  publish_map();
}

void SlamToolbox::load_given_session() {
  if (parameters_.map_file_name.empty()) return;
  using Request = DeserializePoseGraph::Request;
  const std::vector<double>& given = parameters_.map_start_pose;
  const bool is_first = given.empty() && parameters_.map_start_at_dock;
  Pose pose;
  if (given.size() == 3) {
    pose = {given[0], given[1], given[2]};
  } else if (!is_first) {
    RCLCPP_ERROR(get_logger(),
                 "LocalizationSlamToolbox: Incorrect number of arguments for map starting pose. "
                 "Must be in format: [x, y, theta]. Starting at the origin");
  }
  deserialize(parameters_.map_file_name,
              is_first ? Request::START_AT_FIRST_NODE : Request::START_AT_GIVEN_POSE, pose);
}

}  // namespace slam_toolbox
