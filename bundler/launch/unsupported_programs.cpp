// See unsupported_programs.hpp.
#include "bundler/launch/unsupported_programs.hpp"

#include <algorithm>
#include <utility>

#include "bundler/launch/rviz_config.hpp"
#include "bundler/workspace/launch_packages.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace {

/// Packages of programs that are no part of any site, and what stands in for them. A package that
/// is installed is started, whatever its name.
struct StandIn {
  std::string_view package;  ///< ends with `*`: all that begin so
  std::string_view instead;
  std::string_view panel = {};  ///< that the usual layout has in its place
  bool shown = false;           ///< the page shows all that the program would show
};

constexpr std::string_view kBridge =
    "nothing connects to a site: its nodes and its page share a graph";
constexpr std::string_view kControl =
    "no channel of the workspace has ros2_control; a node of the workspace can do its work";
constexpr std::string_view kDevice =
    "it reads a device, which no browser reaches; a node that simulates it, or a bag, can publish";
constexpr std::string_view kGamepad =
    "the workspace does not depend on it; with `dependencies: [joy]` in workspace.yaml it reads "
    "the gamepad of the visitor";
constexpr std::string_view kJoystick =
    "it reads a device, which no browser reaches; `joy_node` of the package `joy` reads the "
    "gamepad of the visitor";
constexpr std::string_view kNavigation =
    "the workspace does not depend on it, or no channel has it; `dependencies:` of workspace.yaml "
    "names packages of channels, `sources:` repositories that have others";
constexpr std::string_view kSimulator = "a site has no simulator";

constexpr StandIn kStandIns[] = {
    {"amcl", kNavigation},
    {"cartographer_ros", kNavigation},
    {"controller_manager", kControl},
    {"foxglove_bridge", kBridge},
    {"gazebo*", kSimulator},
    {"joint_state_publisher_gui", "the panel Joints of the page replaces it", "joints", true},
    {"joy", kGamepad, "teleop"},
    {"joy_linux", kJoystick, "teleop"},
    {"joy_teleop", kNavigation, "teleop"},
    {"micro_ros_agent", kBridge},
    {"moveit*", "MoveIt is not part of a site, its messages are"},
    {"nav2_*", kNavigation},
    {"plotjuggler*", "the page shows the messages of topics", {}, true},
    {"realsense2_camera", kDevice},
    {"robot_localization", kNavigation},
    {"ros_gz*", kSimulator},
    {"ros_ign*", kSimulator},
    {"rosapi", kBridge},
    {"rosbridge_server", kBridge},
    {"rplidar_ros", kDevice},
    {"rqt*", "the page shows nodes and topics", {}, true},
    {"rviz*", "the 3D view of the page replaces it", "scene", true},
    {"sick_scan*", kDevice},
    {"slam_toolbox", kNavigation},
    {"sllidar_ros2", kDevice},
    {"urg_node", kDevice},
    {"usb_cam", kDevice},
    {"v4l2_camera", kDevice},
    {"velodyne_driver", kDevice},
    {"web_video_server", kBridge},
    {"webots_ros2*", kSimulator},
    {"xterm", "a site has no windows of programs"},
    {"ydlidar_ros2_driver", kDevice},
};

Diagnostic left_out(const std::string& what, const std::string& why, const SourceSpan& span) {
  return {.code = "R2W0415",
          .severity = Severity::kWarning,
          .message = "`" + what + "` is skipped",
          .span = span,
          .why = {why}};
}

/// Nothing is wrong: the author need not look at the launch file.
Diagnostic replaced(const std::string& program, const StandIn& stand_in, SourceSpan place) {
  place.line_text.clear();
  return {.code = "R2W0415",
          .severity = Severity::kNote,
          .message = "`" + program + "` is not started: " + std::string(stand_in.instead),
          .span = std::move(place)};
}

constexpr std::size_t kMostDisplays = 12;

/// The word after `-d`; empty when there is none.
std::string configuration_of(const NodeEntry& node) {
  const auto& words = node.arguments;
  const auto option = std::find_if(words.begin(), words.end(), [](const std::string& word) {
    return word == "-d" || word == "--display-config";
  });
  return option == words.end() || option + 1 == words.end() ? std::string() : *(option + 1);
}

/// The displays in the FILE of `rviz2 -d FILE`; empty when it is not a file of the workspace yet.
RvizDisplays displays_of(const NodeEntry& node, const LaunchWorld& world) {
  const std::string file = configuration_of(node);
  if (file.empty()) return {};
  const auto text = world.read(file);
  return text ? rviz_displays(*text) : RvizDisplays{};
}

/// Which displays the page shows, and where.
std::vector<std::string> display_lines(const RvizDisplays& displays) {
  std::vector<std::string> result;
  const auto tell = [&](const std::vector<std::string>& names, const std::string& what) {
    if (!names.empty()) result.push_back(what + ": " + name_list(names, kMostDisplays));
  };
  tell(displays.shown, "the 3D view shows");
  tell(displays.elsewhere, "the panel Image shows");
  tell(displays.missing, "the page does not show");
  return result;
}

const StandIn* find_stand_in(const std::string& package, const IsKnownPackage& is_known) {
  if (is_known(package)) return nullptr;
  for (const StandIn& one : kStandIns) {
    const bool begins = one.package.ends_with('*');
    if (begins ? package.starts_with(one.package.substr(0, one.package.size() - 1))
               : package == one.package)
      return &one;
  }
  return nullptr;
}

/// `/opt/ros/DISTRO/share/PKG/FILE` is `share/PKG/FILE` of the site. Files that no package
/// installs are in none.
std::string place_in_site(const std::string& path) {
  constexpr std::string_view kInstalled = "/opt/ros/";
  const auto share = path.find("/share/");
  if (!path.starts_with(kInstalled) || share == std::string::npos) return {};
  return path.substr(share + 1);
}

}  // namespace

bool has_stand_in(const std::string& package, const IsKnownPackage& is_known) {
  return find_stand_in(package, is_known) != nullptr;
}

std::vector<StandInPanel> stand_in_panels(const LaunchDescription& description,
                                          const IsKnownPackage& is_known) {
  std::vector<StandInPanel> panels;
  const auto add = [&](StandInPanel panel) {
    if (std::none_of(panels.begin(), panels.end(),
                     [&](const StandInPanel& one) { return one.panel == panel.panel; }))
      panels.push_back(std::move(panel));
  };
  for (const LaunchProcess& process : description.processes) {
    const StandIn* found = find_stand_in(process.node.package.value, is_known);
    if (found == nullptr || found->panel.empty()) continue;
    add({.panel = std::string(found->panel),
         .file = place_in_site(configuration_of(process.node))});
  }
  // It says how a gamepad is connected, and drives without one.
  const auto is_joy = [](const auto& started) { return started.node.package.value == "joy"; };
  if (std::any_of(description.processes.begin(), description.processes.end(),
                  [&is_joy](const LaunchProcess& process) {
                    return is_joy(process) || std::any_of(process.components.begin(),
                                                          process.components.end(), is_joy);
                  }))
    add({.panel = "teleop"});
  // In the place of Gazebo's own window.
  if (std::any_of(
          description.processes.begin(), description.processes.end(),
          [](const LaunchProcess& process) { return is_simulator(process.node.package.value); }))
    add({.panel = "simulation"});
  return panels;
}

Diagnostics left_out_of_site(const LaunchDescription& description, const IsKnownPackage& is_known,
                             const LaunchWorld& world) {
  Diagnostics result;
  for (const LaunchLeftOut& one : description.left_out)
    result.push_back(left_out(one.what, one.instead, one.span));
  for (const LaunchProcess& process : description.processes) {
    const NodeEntry& node = process.node;
    const StandIn* found = find_stand_in(node.package.value, is_known);
    if (found == nullptr) continue;
    const std::string program = node.package.value + "/" + node.executable.value;
    const RvizDisplays displays =
        node.package.value.starts_with("rviz") ? displays_of(node, world) : RvizDisplays{};
    if (found->shown && displays.missing.empty()) {
      result.push_back(replaced(program, *found, node.span));
      continue;
    }
    result.push_back(left_out(program, std::string(found->instead), node.span));
    for (std::string& one : display_lines(displays)) result.back().why.push_back(std::move(one));
  }
  return result;
}

Diagnostics refused_when_strict(const Diagnostics& warnings) {
  Diagnostics errors;
  for (Diagnostic one : warnings) {
    if (one.code != "R2W0415") continue;
    one.severity = Severity::kError;
    one.why.emplace_back("`--strict` asks for all that the launch file starts");
    errors.push_back(std::move(one));
  }
  return errors;
}

}  // namespace ros2wasm
