// See rviz_config.hpp.
#include "bundler/launch/rviz_config.hpp"

#include <algorithm>

#include "workspace_schema/source_text.hpp"
#include "workspace_schema/yaml_reader.hpp"

namespace ros2wasm {
namespace {

/// Of rviz_default_plugins; what draws them here is in runtime/ui/scene/kinds.ts.
constexpr std::string_view kShown[] = {
    "Axes",       "Grid", "LaserScan", "Map",       "Marker",      "MarkerArray",
    "Odometry",   "Path", "Pose",      "PoseArray", "PointCloud2", "PoseWithCovariance",
    "RobotModel", "TF",
};
constexpr std::string_view kImage = "Image";

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

void add_displays(const YamlNode& parent, RvizDisplays& result) {
  const YamlNode* displays = member(parent, "Displays");
  if (displays == nullptr) return;
  for (const YamlNode& display : displays->items) {
    if (text_of(display, "Enabled") == "false") continue;
    const std::string plugin = text_of(display, "Class");
    const std::string kind = plugin.substr(plugin.rfind('/') + 1);
    if (kind == "Group") {
      add_displays(display, result);
      continue;
    }
    if (kind.empty()) continue;
    std::string name = text_of(display, "Name");
    if (name.empty()) name = kind;
    if (const std::string topic = topic_of(display); !topic.empty()) name += " (" + topic + ")";
    const bool is_shown = plugin.starts_with("rviz_default_plugins/") &&
                          std::find(std::begin(kShown), std::end(kShown), kind) != std::end(kShown);
    (is_shown         ? result.shown
     : kind == kImage ? result.elsewhere
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
