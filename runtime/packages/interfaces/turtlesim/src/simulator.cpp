// See simulator.hpp.
#include "simulator.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

namespace turtlesim {
namespace {

constexpr std::chrono::milliseconds kTick{16};
constexpr double kTickSeconds = 0.016;  // fixed: a late tick moves turtles no further
constexpr int kShapes = 10;

struct Channel {
  const char* parameter;
  const char* description;
  int value;
};
constexpr std::array<Channel, 3> kBackground = {
    {{"background_r", "Red channel of the background color", 69},
     {"background_g", "Green channel of the background color", 86},
     {"background_b", "Blue channel of the background color", 255}}};

}  // namespace

Simulator::Simulator(rclcpp::Node::SharedPtr node)
    : node_(std::move(node)), shapes_(std::random_device{}()) {
  declare_parameters();
  scene_ = node_->create_publisher<Scene>("~/_scene", rclcpp::QoS(64).transient_local());
  parameter_events_ = node_->create_subscription<rcl_interfaces::msg::ParameterEvent>(
      "/parameter_events", rclcpp::ParameterEventsQoS(),
      [this](const rcl_interfaces::msg::ParameterEvent& event) {
        changed_ = changed_ || event.node == node_->get_fully_qualified_name();
      });
  create_services();
  RCLCPP_INFO(node_->get_logger(), "Starting turtlesim with node name %s",
              node_->get_fully_qualified_name());
  spawn_first();
  timer_ = node_->create_wall_timer(kTick, [this] { update(); });
}

void Simulator::declare_parameters() {
  rcl_interfaces::msg::IntegerRange range;
  range.from_value = 0;
  range.to_value = 255;
  range.step = 1;
  for (const Channel& channel : kBackground) {
    rcl_interfaces::msg::ParameterDescriptor descriptor;
    descriptor.description = channel.description;
    descriptor.integer_range.push_back(range);
    node_->declare_parameter(channel.parameter, channel.value, descriptor);
  }
  rcl_interfaces::msg::ParameterDescriptor descriptor;
  descriptor.description = "If true, then turtles will be holonomic";
  node_->declare_parameter("holonomic", false, descriptor);
}

void Simulator::create_services() {
  using Empty = std_srvs::srv::Empty;
  clear_service_ = node_->create_service<Empty>(
      "clear", [this](const Empty::Request::SharedPtr, Empty::Response::SharedPtr) {
        RCLCPP_INFO(node_->get_logger(), "Clearing turtlesim.");
        paper_.clear();
        changed_ = true;
      });
  reset_service_ = node_->create_service<Empty>(
      "reset", [this](const Empty::Request::SharedPtr, Empty::Response::SharedPtr) {
        RCLCPP_INFO(node_->get_logger(), "Resetting turtlesim.");
        turtles_.clear();
        last_number_ = 0;
        spawn_first();
        paper_.clear();
      });
  spawn_service_ = node_->create_service<srv::Spawn>(
      "spawn", [this](const srv::Spawn::Request::SharedPtr request,
                      srv::Spawn::Response::SharedPtr response) {
        response->name = spawn(request->name, request->x, request->y, request->theta);
      });
  kill_service_ = node_->create_service<srv::Kill>(
      "kill", [this](const srv::Kill::Request::SharedPtr request, srv::Kill::Response::SharedPtr) {
        kill(request->name);
      });
  picture_service_ = node_->create_service<GetPicture>(
      "~/_get_picture",
      [this](const GetPicture::Request::SharedPtr, GetPicture::Response::SharedPtr response) {
        fill_picture(*response);
      });
}

void Simulator::spawn_first() {
  spawn("", kFieldUnits / 2, kFieldUnits / 2, 0);
}

std::string Simulator::spawn(const std::string& name, double x, double y, double theta) {
  std::string real_name = name;
  while (real_name.empty() || (name.empty() && turtles_.count(real_name) != 0)) {
    real_name = "turtle" + std::to_string(++last_number_);
  }
  if (turtles_.count(real_name) != 0) {
    RCLCPP_ERROR(node_->get_logger(), "A turtle named [%s] already exists", real_name.c_str());
    return "";
  }
  try {
    const auto shape = static_cast<std::uint8_t>(shapes_() % kShapes);
    turtles_[real_name] = std::make_unique<Turtle>(*node_, real_name, x, y, theta, shape);
  } catch (const std::exception& error) {  // the name is a part of topic names
    turtles_.erase(real_name);
    RCLCPP_ERROR(node_->get_logger(), "Cannot spawn a turtle named [%s]: %s", real_name.c_str(),
                 error.what());
    return "";
  }
  changed_ = true;
  RCLCPP_INFO(node_->get_logger(), "Spawning turtle [%s] at x=[%f], y=[%f], theta=[%f]",
              real_name.c_str(), x, y, theta);
  return real_name;
}

void Simulator::kill(const std::string& name) {
  if (turtles_.erase(name) == 0) {
    RCLCPP_ERROR(node_->get_logger(), "Tried to kill turtle [%s], which does not exist",
                 name.c_str());
    return;
  }
  changed_ = true;
}

void Simulator::update() {
  const bool holonomic = node_->get_parameter("holonomic").as_bool();
  for (const auto& [name, turtle] : turtles_) {
    changed_ |= turtle->update(kTickSeconds, paper_, holonomic);
  }
  if (std::exchange(changed_, false)) publish_scene();
}

void Simulator::publish_scene() {
  Scene scene;
  scene.width = Paper::kSize;
  scene.height = Paper::kSize;
  scene.meter = static_cast<float>(kPixelsPerUnit);
  for (std::size_t i = 0; i < kBackground.size(); ++i) {
    const auto value = node_->get_parameter(kBackground[i].parameter).as_int();
    scene.background[i] = static_cast<std::uint8_t>(value);
  }
  for (const auto& [name, turtle] : turtles_) scene.turtles.push_back(turtle->drawn());
  const auto strokes = paper_.take_new_strokes();
  scene.picture = paper_.number();
  scene.first = paper_.stroke_count() - static_cast<std::uint32_t>(strokes.size());
  for (const PenStroke& one : strokes) {
    turtlesim_scene::msg::Stroke stroke;
    stroke.x1 = static_cast<float>(one.from.x);
    stroke.y1 = static_cast<float>(one.from.y);
    stroke.x2 = static_cast<float>(one.to.x);
    stroke.y2 = static_cast<float>(one.to.y);
    stroke.r = one.color.r;
    stroke.g = one.color.g;
    stroke.b = one.color.b;
    stroke.width = static_cast<std::uint8_t>(one.width);
    scene.strokes.push_back(stroke);
  }
  scene_->publish(scene);
}

void Simulator::fill_picture(GetPicture::Response& response) const {
  response.picture = paper_.number();
  response.strokes = paper_.stroke_count();
  response.width = Paper::kSize;
  response.height = Paper::kSize;
  for (const PixelRun& run : paper_.runs()) {
    response.lengths.push_back(run.length);
    response.colors.push_back(run.argb);
  }
}

}  // namespace turtlesim
