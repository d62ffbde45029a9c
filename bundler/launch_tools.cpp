// See launch_tools.hpp.
#include "bundler/launch_tools.hpp"

#include <memory>
#include <utility>

#include "bundler/io/installation.hpp"
#include "bundler/launch/python_tree.hpp"
#include "bundler/resolve/solve.hpp"
#include "bundler/run/node_js.hpp"
#include "bundler/store/environment.hpp"
#include "bundler/workspace/workspace_channels.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// Pyodide of the program's own channel, unpacked in the cache.
Outcome<fs::path> own_pyodide(const fs::path& executable,
                              const std::map<std::string, std::string>& variables,
                              const Cancellation& cancellation) {
  Manifest nothing;
  auto channels = workspace_channels(nothing, fs::current_path(), executable, variables);
  if (!channels) return std::move(channels).errors();
  auto& [roots, addresses] = *channels;
  roots.network.offline = true;
  const auto open = open_channels(addresses, roots, cancellation);
  if (!open) return open.errors();
  const std::string wanted(kPyodidePackage);
  const auto index = open->reachable({&wanted, 1}, nothing.channel_priority, cancellation);
  if (!index) return index.errors();
  const auto solved = solve(
      {.specs = {{.text = wanted, .origin = "launch files in Python", .span = {}}}, .locked = {}},
      *index);
  if (!solved) return no_pyodide("a launch file is written in Python");
  const Store store(roots, {});
  const auto environment = make_environment(store, solved->packages, cancellation);
  if (!environment) return environment.errors();
  return environment->prefix / kPyodideFolder;
}

}  // namespace

Outcome<PythonTools> find_launch_tools(const fs::path& executable,
                                       const std::map<std::string, std::string>& variables,
                                       const fs::path& environment,
                                       const Cancellation& cancellation) {
  const auto path = variables.find("PATH");
  auto node = find_node_js(executable, path == variables.end() ? "" : path->second, cancellation);
  if (!node) return std::move(node).errors();
  const auto templates =
      find_own_data(executable, "templates/python", "the reader of Python files");
  if (!templates) return templates.errors();
  std::error_code error;
  fs::path pyodide = environment / kPyodideFolder;
  if (environment.empty() || !fs::is_directory(pyodide, error)) {
    auto own = own_pyodide(executable, variables, cancellation);
    if (!own) return std::move(own).errors();
    pyodide = std::move(*own);
  }
  return PythonTools{.node_js = std::move(*node),
                     .pyodide = fs::canonical(pyodide, error),
                     .templates = fs::canonical(*templates, error)};
}

LaunchPython launch_python(const std::vector<LaunchFolder>& folders,
                           std::function<Outcome<PythonTools>()> find_tools,
                           const Cancellation& cancellation) {
  const auto host = std::make_shared<PythonHost>(std::move(find_tools), folders, cancellation);
  return [host](const std::string& request,
                const std::function<std::string(const std::string&)>& reply) {
    return host->ask(request, reply);
  };
}

}  // namespace ros2wasm
