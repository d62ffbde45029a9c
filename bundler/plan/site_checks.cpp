// See site_checks.hpp.
#include "bundler/plan/site_checks.hpp"

#include <filesystem>

#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace {

/// The ids that a name can mean: of the first kind of name that fits.
std::vector<std::string> meant_by(const std::string& name, const std::vector<LaunchNode>& nodes) {
  std::vector<std::string> found;
  for (const auto field : {&LaunchNode::id, &LaunchNode::label, &LaunchNode::executable}) {
    for (const LaunchNode& node : nodes)
      if (node.*field == name) found.push_back(node.id);
    if (!found.empty()) return found;
  }
  return found;
}

std::optional<Diagnostic> name_node(Spanned<std::string>& name,
                                    const std::vector<LaunchNode>& nodes) {
  const auto ids = meant_by(name.value, nodes);
  if (ids.size() == 1) {
    name.value = ids.front();
    return std::nullopt;
  }
  if (!ids.empty()) {
    return Diagnostic{.code = "R2W0430",
                      .message = "`" + name.value + "` is the name of several nodes of the site",
                      .span = name.span,
                      .why = {"they are: " + name_list(ids, 12)},
                      .fix = {"write `node: " + ids.front() + "`"}};
  }
  std::vector<std::string> known;
  for (const LaunchNode& node : nodes) known.push_back(node.id);
  Diagnostic error{.code = "R2W0430",
                   .message = "the site has no node `" + name.value + "`",
                   .span = name.span,
                   .why = {"its nodes are: " + name_list(known, 12)}};
  for (const LaunchNode& node : nodes) known.push_back(node.executable);
  if (const auto near = nearest(name.value, known))
    error.fix.push_back("write `node: " + *near + "`");
  return error;
}

}  // namespace

Outcome<std::vector<CheckEntry>> site_checks(std::vector<CheckEntry> checks,
                                             const std::vector<LaunchNode>& nodes) {
  Diagnostics errors;
  const auto name = [&](Spanned<std::string>& node) {
    if (auto error = name_node(node, nodes)) errors.push_back(*std::move(error));
  };
  for (CheckEntry& check : checks) {
    if (auto* log = std::get_if<LogCheck>(&check.what); log != nullptr && log->node)
      name(*log->node);
    if (auto* state = std::get_if<StateCheck>(&check.what)) name(state->node);
    if (auto* exit = std::get_if<ExitCheck>(&check.what)) name(exit->node);
    // The same site whatever folder the pack was started in.
    check.span.file = std::filesystem::path(check.span.file).filename().string();
  }
  if (!errors.empty()) return errors;
  return checks;
}

}  // namespace ros2wasm
