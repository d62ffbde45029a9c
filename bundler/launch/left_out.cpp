// See left_out.hpp.
#include "bundler/launch/left_out.hpp"

#include <algorithm>
#include <utility>

#include "bundler/launch/rviz_config.hpp"
#include "workspace_schema/suggestion.hpp"

namespace ros2wasm {
namespace {

/// Packages of programs that are no part of any site, and what stands in for them. A package that
/// is installed is started, whatever its name.
struct StandIn {
  std::string_view package;  ///< ends with `*`: all that begin so
  std::string_view instead;
};

constexpr StandIn kStandIns[] = {
    {"gazebo*", "a site has no simulator"},
    {"ros_gz*", "a site has no simulator"},
    {"ros_ign*", "a site has no simulator"},
    {"joint_state_publisher_gui", "joint_state_publisher publishes the joints' zero positions"},
    {"plotjuggler*", "the page shows the messages of topics"},
    {"rqt*", "the page shows nodes and topics"},
    {"rviz*", "the 3D view of the page stands in for it"},
    {"xterm", "a site has no windows of programs"},
};

Diagnostic left_out(const std::string& what, const std::string& why, const SourceSpan& span) {
  return {.code = "R2W0415",
          .severity = Severity::kWarning,
          .message = "`" + what + "` is left out of the site",
          .span = span,
          .why = {why}};
}

constexpr std::size_t kMostDisplays = 12;

/// What of the configuration that `rviz2 -d FILE` has is shown, and where.
std::vector<std::string> displays_of(const NodeEntry& node, const LaunchWorld& world) {
  const auto& words = node.arguments;
  const auto option = std::find_if(words.begin(), words.end(), [](const std::string& word) {
    return word == "-d" || word == "--display-config";
  });
  if (option == words.end() || option + 1 == words.end()) return {};
  const auto text = world.read(*(option + 1));
  if (!text) return {};  // it may be made later, or lie where no site looks
  const RvizDisplays displays = rviz_displays(*text);
  std::vector<std::string> result;
  const auto tell = [&](const std::vector<std::string>& names, const std::string& what) {
    if (!names.empty()) result.push_back(what + ": " + name_list(names, kMostDisplays));
  };
  tell(displays.shown, "of what its configuration displays it shows");
  tell(displays.elsewhere, "the panel Image shows");
  tell(displays.missing, "the page does not show");
  return result;
}

}  // namespace

std::optional<std::string> stand_in(const std::string& package, const IsKnownPackage& is_known) {
  if (is_known(package)) return std::nullopt;
  for (const StandIn& one : kStandIns) {
    const bool begins = one.package.ends_with('*');
    if (begins ? package.starts_with(one.package.substr(0, one.package.size() - 1))
               : package == one.package)
      return std::string(one.instead);
  }
  return std::nullopt;
}

Diagnostics left_out_of_site(const LaunchDescription& description, const IsKnownPackage& is_known,
                             const LaunchWorld& world) {
  Diagnostics result;
  for (const LaunchLeftOut& one : description.left_out)
    result.push_back(left_out(one.what, one.instead, one.span));
  for (const LaunchProcess& process : description.processes) {
    const NodeEntry& node = process.node;
    const auto instead = stand_in(node.package.value, is_known);
    if (!instead) continue;
    result.push_back(
        left_out(node.package.value + "/" + node.executable.value, *instead, node.span));
    if (!node.package.value.starts_with("rviz")) continue;
    for (std::string& one : displays_of(node, world)) result.back().why.push_back(std::move(one));
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
