// See headless_command.hpp.
#include "bundler/run/headless_command.hpp"

#include "bundler/io/files.hpp"
#include "bundler/io/installation.hpp"
#include "bundler/io/process.hpp"
#include "workspace_schema/base/json_reader.hpp"

namespace ros2wasm {
namespace {

/// Takes the name only: the whole list is checked when a site is packed.
Outcome<std::string> headless_name(const std::filesystem::path& list, std::string_view role) {
  const auto text = read_file(list, kMostOfList);
  if (!text) return text.errors();
  const auto parsed = parse_json(*text, list.string(), "R2W0604");
  if (!parsed) return parsed.errors();
  if (const JsonValue* assets = parsed->find("assets")) {
    for (const JsonValue& asset : assets->items()) {
      if (asset.text_of("role") == role) return asset.text_of("file");
    }
  }
  return Diagnostic{.code = "R2W0623",
                    .kind = FailureKind::kEnvironment,
                    .message = "this installation of ros2wasm cannot run sites in Node.js",
                    .why = {list.string() + " names no file of role `" + std::string(role) + "`"}};
}

}  // namespace

Outcome<std::filesystem::path> find_headless_program(const std::filesystem::path& executable,
                                                     std::string_view role) {
  const auto list = find_own_data(executable, "runtime/runtime_assets.json",
                                  "the runtime that every site is made with");
  if (!list) return list.errors();
  const auto name = headless_name(*list, role);
  if (!name) return name.errors();
  return list->parent_path() / *name;
}

Outcome<Done> check_pattern(const std::filesystem::path& node_js, const std::string& pattern,
                            const Cancellation& cancellation) {
  const std::string program =
      "try { new RegExp(process.argv[1]) } "
      "catch (e) { process.stdout.write(e.message); process.exit(1) }";
  const auto checked = run_process({.arguments = {node_js.string(), "-e", program, "--", pattern},
                                    .environment = {},
                                    .directory = {},
                                    .output_mode = OutputMode::kCapture,
                                    .on_output = {}},
                                   cancellation);
  if (!checked) return checked.errors();
  if (checked->exit_code == 0) return Done{};
  return Diagnostic{.code = "R2W0622",
                    .kind = FailureKind::kCommandLine,
                    .message = "`" + pattern + "` is not a regular expression",
                    .why = {checked->output.empty() ? checked->error : checked->output}};
}

std::vector<std::string> headless_command(const std::filesystem::path& node_js,
                                          const std::filesystem::path& program,
                                          const HeadlessRun& run) {
  std::vector<std::string> words = {node_js.string(), program.string(), run.site.string()};
  if (run.limit) {
    words.emplace_back("--for");
    words.push_back(std::to_string(run.limit->count()) + "ms");
  }
  if (run.until) {
    words.emplace_back("--until");
    words.push_back(*run.until);
  }
  if (!run.link.empty()) {
    words.emplace_back("--link");
    words.push_back(run.link);
  }
  if (run.stepped) words.emplace_back("--stepped");
  if (run.seed) {
    words.emplace_back("--seed");
    words.push_back(std::to_string(*run.seed));
  }
  if (run.trace) {
    words.emplace_back("--trace");
    words.push_back(*run.trace);
  }
  if (run.bags) {
    words.emplace_back("--bags");
    words.push_back(*run.bags);
  }
  if (run.checks) words.emplace_back("--checks");
  if (run.junit) {
    words.emplace_back("--junit");
    words.push_back(*run.junit);
  }
  if (run.json) words.emplace_back("--json");
  if (run.show_arguments) words.emplace_back("--show-args");
  if (!run.given.empty()) words.emplace_back("--");
  words.insert(words.end(), run.given.begin(), run.given.end());
  return words;
}

}  // namespace ros2wasm
