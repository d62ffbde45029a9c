// See headless_command.hpp.
#include "bundler/run/headless_command.hpp"

#include "bundler/io/files.hpp"
#include "bundler/io/process.hpp"
#include "workspace_schema/json_reader.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kAssetList = "runtime_assets.json";

Diagnostic no_headless(std::vector<std::string> why) {
  return Diagnostic{.code = "R2W0623",
                    .kind = FailureKind::kEnvironment,
                    .message = "the part of ros2wasm that runs sites in Node.js is not there",
                    .why = std::move(why)};
}

Outcome<std::filesystem::path> headless_in(const std::filesystem::path& folder) {
  const auto text = read_file(folder / kAssetList);
  if (!text) return text.errors();
  const auto list = parse_json(*text, (folder / kAssetList).string(), "R2W0623");
  if (!list) return list.errors();
  const JsonValue* assets = list->find("assets");
  if (assets != nullptr) {
    for (const JsonValue& asset : assets->items()) {
      if (asset.text_of("role") == "headless") return folder / asset.text_of("file");
    }
  }
  return no_headless({(folder / kAssetList).string() + " names no file of role `headless`"});
}

}  // namespace

Outcome<std::filesystem::path> find_headless_program(const std::filesystem::path& executable) {
  const auto folder = executable.parent_path();
  std::vector<std::string> why;
  for (const auto& place :
       {folder / "runtime", folder.parent_path() / "share" / "ros2wasm" / "runtime"}) {
    std::error_code error;
    if (std::filesystem::exists(place / kAssetList, error)) return headless_in(place);
    why.push_back("there is no " + (place / kAssetList).string());
  }
  return no_headless(std::move(why));
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
  if (run.json) words.emplace_back("--json");
  return words;
}

}  // namespace ros2wasm
