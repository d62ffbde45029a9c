// See python_host.hpp. The messages are described in templates/python/read_launch.mjs.
#include "bundler/launch/host/python_host.hpp"

#include <chrono>
#include <vector>

#include "bundler/io/python_sandbox.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr std::chrono::seconds kTimeLimit{60};  // of one request, of its processor

}  // namespace

Outcome<Done> PythonHost::start() {
  const auto tools = find_tools_();
  if (!tools) return tools.errors();
  std::vector<fs::path> readable{tools->pyodide, tools->templates};
  JsonWriter first;
  first.begin_object().key("folders").begin_array();
  for (const LaunchFolder& folder : folders_) {
    std::error_code error;
    const fs::path real = fs::canonical(folder.from, error);
    if (error || !fs::is_directory(real, error)) continue;  // a package without files
    readable.push_back(real);
    first.begin_object().field("at", folder.at).field("from", real.string()).end_object();
  }
  first.end_array().key("modules").begin_array();
  for (const LaunchFolder& folder : folders_)
    if (folder.holds_modules) first.string(folder.at);
  first.end_array().end_object();
  const fs::path reader = tools->templates / "read_launch.mjs";
  auto started = Conversation::start(
      python_sandbox(tools->node_js, readable, {reader.string(), tools->pyodide.string()}),
      cancellation_);
  if (!started) return std::move(started).errors();
  if (const auto ready = (*started)->ask(first.text()); !ready) return ready.errors();
  conversation_ = std::move(*started);
  return Done{};
}

Outcome<std::string> PythonHost::ask(const std::string& request,
                                     const std::function<std::string(const std::string&)>& reply) {
  if (!conversation_) {
    if (auto started = start(); !started) return started.errors();
  }
  const Patience patience = conversation_->patience(kTimeLimit);
  std::string line = request;
  for (;;) {
    auto answer = conversation_->ask(line, patience);
    if (!answer && conversation_->is_out_of_time()) {
      return Diagnostic{.code = "R2W0416",
                        .message = "a launch file does not end",
                        .why = {"it was given " + std::to_string(kTimeLimit.count()) +
                                " seconds of a processor, and ten times as many by the clock; the "
                                "clock that it sees does not advance"}};
    }
    // An answer that is itself a question begins with "ask".
    if (!answer || !answer->starts_with("{\"ask\": ")) return answer;
    line = reply(*answer);
  }
}

std::optional<SeenPaths> PythonHost::seen() {
  if (!conversation_) return std::nullopt;
  const auto answer = conversation_->ask("\"seen\"", conversation_->patience(kTimeLimit));
  return answer ? read_seen_paths(*answer) : std::nullopt;
}

}  // namespace ros2wasm
