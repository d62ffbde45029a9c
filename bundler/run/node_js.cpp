// See node_js.hpp.
#include "bundler/run/node_js.hpp"

#include <charconv>

#include "bundler/io/installation.hpp"
#include "bundler/io/process.hpp"

namespace ros2wasm {
namespace {

std::string text_of(const NodeJsVersion& version) {
  return std::to_string(version.major) + "." + std::to_string(version.minor);
}

Diagnostic no_node_js(std::string why) {
  return Diagnostic{.code = "R2W0620",
                    .kind = FailureKind::kEnvironment,
                    .message = "Node.js " + text_of(kOldestNodeJs) +
                               " or newer is needed: it runs sites without a browser, and reads "
                               "what a workspace has in Python",
                    .why = {std::move(why)},
                    .fix = {"npm install --prefix ~/.local/node-for-ros2wasm node && "
                            "export PATH=~/.local/node-for-ros2wasm/node_modules/.bin:$PATH"}};
}

}  // namespace

std::optional<NodeJsVersion> node_js_version(std::string_view version_text) {
  if (!version_text.starts_with('v')) return std::nullopt;
  const char* const last = version_text.data() + version_text.size();
  NodeJsVersion version;
  const auto major = std::from_chars(version_text.data() + 1, last, version.major);
  if (major.ec != std::errc() || major.ptr == last || *major.ptr != '.') return std::nullopt;
  const auto minor = std::from_chars(major.ptr + 1, last, version.minor);
  if (minor.ec != std::errc() || minor.ptr == last || *minor.ptr != '.') return std::nullopt;
  return version;
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
  const auto version = asked->exit_code == 0 ? node_js_version(asked->output) : std::nullopt;
  if (!version) return no_node_js("`" + found->string() + " --version` gives no version");
  if (*version < kOldestNodeJs) {
    return no_node_js("`" + found->string() + "` is version " + text_of(*version));
  }
  return *found;
}

}  // namespace ros2wasm
