// `ros2wasm tree [NAME]`: who needs whom, as ros2wasm.lock says.
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "bundler/io/files.hpp"
#include "bundler/resolve/lock_graph.hpp"
#include "bundler/resolve/locked_solve.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "cli/workspace_lock.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace {

struct TreeOptions {
  std::string name;
  std::string workspace;
};

/// Prints a package under those that need it; what it needs itself is shown once only.
class TreePrinter {
 public:
  TreePrinter(Context& context, const LockGraph& graph)
      : context_(context), graph_(graph), shown_(graph.size(), false) {}

  void root(std::size_t i) {
    context_.console.result(label(i));
    children(i, "");
  }

 private:
  std::string label(std::size_t i) {
    const PackageRecord& record = graph_.package(i);
    const bool again = shown_[i] && !graph_.needs(i).empty();
    return record.name + " " + record.version + (again ? " (see above)" : "");
  }

  void children(std::size_t i, const std::string& indent) {
    if (shown_[i]) return;
    shown_[i] = true;
    const auto& needs = graph_.needs(i);
    for (std::size_t k = 0; k < needs.size(); ++k) {
      const bool last = k + 1 == needs.size();
      const std::string spec = needs[k].spec;
      const std::size_t space = spec.find_first_of(" <>=!~[");
      context_.console.result(indent + (last ? "`-- " : "|-- ") + label(needs[k].package) +
                              (space == std::string::npos ? "" : "  [" + spec + "]"));
      children(needs[k].package, indent + (last ? "    " : "|   "));
    }
  }

  Context& context_;
  const LockGraph& graph_;
  std::vector<bool> shown_;
};

/// Marks a package and all that it needs.
void reach(const LockGraph& graph, std::size_t i, std::vector<bool>& reached) {
  if (reached[i]) return;
  reached[i] = true;
  for (const LockEdge& edge : graph.needs(i)) reach(graph, edge.package, reached);
}

/// The packages that are built here, below the source that they come from, and models.
void print_sources(Context& context, const Lock& lock) {
  for (const LockedSource& source : lock.sources) {
    context.console.result((source.model.empty() ? "built from " : source.model + " from ") +
                           title_of(source));
    for (std::size_t k = 0; k < source.packages.size(); ++k)
      context.console.result((k + 1 == source.packages.size() ? "`-- " : "|-- ") +
                             source.packages[k]);
  }
}

void print_json(Context& context, const LockGraph& graph, const std::vector<std::string>& asked_for,
                const std::vector<bool>& shown, const std::vector<LockedSource>& sources) {
  JsonWriter json;
  json.begin_object().key("asked_for").begin_array();
  for (const std::string& spec : asked_for) json.string(spec);
  json.end_array().key("packages").begin_array();
  for (std::size_t i = 0; i < graph.size(); ++i) {
    if (!shown[i]) continue;
    const PackageRecord& record = graph.package(i);
    json.begin_object().field("name", record.name).field("version", record.version);
    json.field("build", record.build).field("channel", record.channel);
    json.key("needs").begin_array();
    for (const LockEdge& edge : graph.needs(i)) {
      json.begin_object().field("name", graph.package(edge.package).name);
      json.field("spec", edge.spec).end_object();
    }
    json.end_array().end_object();
  }
  json.end_array().key("sources").begin_array();
  for (const LockedSource& source : sources) write_source(json, source);
  json.end_array().end_object();
  context.console.result(json.text());
}

int run(Context& context, const TreeOptions& options) {
  const auto lock = read_workspace_lock(options.workspace);
  if (!lock) return context.console.fail(lock.errors());
  const LockGraph graph(*lock);
  TreePrinter printer(context, graph);
  if (!options.name.empty()) {
    const auto package = graph.find(options.name);
    if (!package) {
      const LockedSource* source = source_of_package(*lock, options.name);
      if (source == nullptr) return context.console.fail(not_in_lock(options.name, lock->packages));
      if (context.json) {
        print_json(context, graph, {options.name}, std::vector<bool>(graph.size(), false),
                   {*source});
      } else {
        context.console.result(options.name + " is built from " + title_of(*source));
      }
      return 0;
    }
    if (context.json) {
      std::vector<bool> reached(graph.size(), false);
      reach(graph, *package, reached);
      print_json(context, graph, {options.name}, reached, {});
    } else {
      printer.root(*package);
    }
    return 0;
  }
  if (context.json) {
    std::vector<std::string> asked_for;
    for (const LockEdge& root : graph.roots()) asked_for.push_back(root.spec);
    print_json(context, graph, asked_for, std::vector<bool>(graph.size(), true), lock->sources);
    return 0;
  }
  for (const LockEdge& root : graph.roots()) printer.root(root.package);
  print_sources(context, *lock);
  return 0;
}

}  // namespace

CommandBody tree_command(Arguments& arguments) {
  const auto options = std::make_shared<TreeOptions>();
  arguments.optional("NAME", options->name, "begin at this package [at all that was asked for]");
  arguments.value("-w,--workspace", options->workspace, "FOLDER",
                  "the folder of ros2wasm.lock [the current one]");
  arguments.examples({"ros2wasm tree", "ros2wasm tree ros-jazzy-rclcpp"});
  return [options](Context& context) { return run(context, *options); };
}

}  // namespace ros2wasm
