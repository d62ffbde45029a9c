// See rviz_config.hpp.
#include "bundler/launch/rviz_config.hpp"

#include <algorithm>
#include <span>

#include "workspace_schema/base/source_text.hpp"
#include "workspace_schema/base/yaml_reader.hpp"

namespace ros2wasm {
namespace {

/// The kinds of displays that the page draws (runtime/site/ui/scene/kinds.ts). Its own list is
/// kDrawn in runtime/site/ui/model/rviz_config.ts; a test compares the two.
constexpr std::string_view kDrawn[] = {
    "AccelStamped",  "GridCells",
    "LaserScan",     "Map",
    "Marker",        "MarkerArray",
    "Odometry",      "Path",
    "PointCloud2",   "PointStamped",
    "Polygon",       "Pose",
    "PoseArray",     "PoseWithCovariance",
    "Range",         "RobotModel",
    "TwistStamped",  "Wrench",
    "WrenchStamped",
};
/// Without a topic.
constexpr std::string_view kOfTheScene[] = {"Grid", "TF"};
/// Drawn over the scene, or in a panel of their own.
constexpr std::string_view kPictures[] = {"Image", "Camera"};

const YamlNode* member(const YamlNode& map, std::string_view key) {
  if (map.kind != YamlKind::kMap) return nullptr;
  const auto entry = std::find_if(map.entries.begin(), map.entries.end(),
                                  [&](const YamlEntry& one) { return one.key == key; });
  return entry == map.entries.end() ? nullptr : &entry->value;
}

std::string text_of(const YamlNode& map, std::string_view key) {
  const YamlNode* value = member(map, key);
  return value != nullptr && value->kind == YamlKind::kScalar ? value->text : std::string();
}

/// `Topic: /scan`, as it was once written, or with its QoS.
std::string topic_of(const YamlNode& display) {
  for (const std::string_view key : {"Topic", "Description Topic", "Image Topic", "Marker Topic"}) {
    const YamlNode* topic = member(display, key);
    if (topic == nullptr) continue;
    const std::string name =
        topic->kind == YamlKind::kScalar ? topic->text : text_of(*topic, "Value");
    if (!name.empty()) return name;
  }
  return {};
}

/// As RViz: what does not say so is off, and its value stands for that.
bool is_on(const YamlNode& display) {
  const std::string enabled = text_of(display, "Enabled");
  return (enabled.empty() ? text_of(display, "Value") : enabled) == "true";
}

bool is_among(std::span<const std::string_view> kinds, std::string_view kind) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

void add_displays(const YamlNode& parent, RvizDisplays& result) {
  const YamlNode* displays = member(parent, "Displays");
  if (displays == nullptr) return;
  for (const YamlNode& display : displays->items) {
    if (!is_on(display)) continue;
    const std::string plugin = text_of(display, "Class");
    const std::string kind = plugin.substr(plugin.rfind('/') + 1);
    if (kind == "Group") {
      add_displays(display, result);
      continue;
    }
    if (kind.empty()) continue;
    std::string name = text_of(display, "Name");
    if (name.empty()) name = kind;
    const std::string topic = topic_of(display);
    if (!topic.empty()) name += " (" + topic + ")";
    // `rviz` is what ROS 1 calls it.
    const bool is_known =
        plugin.starts_with("rviz_default_plugins/") || plugin.starts_with("rviz/");
    const bool is_shown =
        is_known && (is_among(kOfTheScene, kind) || (is_among(kDrawn, kind) && !topic.empty()));
    (is_shown                                                  ? result.shown
     : is_known && is_among(kPictures, kind) && !topic.empty() ? result.elsewhere
                                                               : result.missing)
        .push_back(std::move(name));
  }
}

}  // namespace

RvizDisplays rviz_displays(std::string_view text) {
  RvizDisplays result;
  const SourceText source(text, "rviz");
  const auto document = parse_yaml(source, DuplicateKeys::kLastCounts);
  if (!document) return result;
  if (const YamlNode* manager = member(document->root, "Visualization Manager"))
    add_displays(*manager, result);
  return result;
}

}  // namespace ros2wasm
