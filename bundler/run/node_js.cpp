// See node_js.hpp.
#include "bundler/run/node_js.hpp"

#include <charconv>

#include "bundler/io/installation.hpp"
#include "bundler/io/process.hpp"

namespace ros2wasm {
namespace {

Diagnostic no_node_js(std::string why) {
  return Diagnostic{.code = "R2W0620",
                    .kind = FailureKind::kEnvironment,
                    .message = "Node.js " + std::to_string(kOldestNodeJs) +
                               " or newer is needed to run a site without a browser",
                    .why = {std::move(why)},
                    .fix = {"npm install --prefix ~/.local/node-for-ros2wasm node && "
                            "export PATH=~/.local/node-for-ros2wasm/node_modules/.bin:$PATH"}};
}

}  // namespace

std::optional<int> node_js_major(std::string_view version_text) {
  if (!version_text.starts_with('v')) return std::nullopt;
  version_text.remove_prefix(1);
  int major = 0;
  const auto [end, error] =
      std::from_chars(version_text.data(), version_text.data() + version_text.size(), major);
  if (error != std::errc() || end == version_text.data() + version_text.size() || *end != '.')
    return std::nullopt;
  return major;
}

Outcome<std::filesystem::path> find_node_js(const std::filesystem::path& executable,
                                            std::string_view path_variable,
                                            const Cancellation& cancellation) {
  if (auto pinned = find_npm_tool(executable, "node")) return std::move(*pinned);
  const auto found = find_program("node", path_variable);
  if (!found) return no_node_js("there is no `node` in PATH");
  const auto asked = run_process({.arguments = {found->string(), "--version"},
                                  .environment = {},
                                  .directory = {},
                                  .output_mode = OutputMode::kCapture,
                                  .on_output = {}},
                                 cancellation);
  if (!asked) return asked.errors();
  const auto major = asked->exit_code == 0 ? node_js_major(asked->output) : std::nullopt;
  if (!major) return no_node_js("`" + found->string() + " --version` gives no version");
  if (*major < kOldestNodeJs) {
    return no_node_js("`" + found->string() + "` is version " + std::to_string(*major));
  }
  return *found;
}

}  // namespace ros2wasm
