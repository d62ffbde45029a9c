// See program_files.hpp.
#include "bundler/program_files.hpp"

#include "bundler/archive/wasm_module.hpp"
#include "bundler/build/exception_encoding.hpp"
#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;

Outcome<Done> read_programs(const PackRequest& request, const BuiltWorkspace& workspace,
                            const std::vector<LaunchNode>& nodes, PlanInput& input,
                            const Cancellation& cancellation) {
  const auto& options = workspace.read.manifest.site;
  const auto exceptions = options.find("exceptions");
  const bool standard = exceptions != options.end() && exceptions->second == "standard";
  for (const LaunchNode& node : nodes) {
    if (node.kind != ProgramKind::kWasm || input.programs.contains(node.program)) continue;
    auto bytes = read_file(node.program, kMostOfData);
    const fs::path names = fs::path(node.program).replace_extension(".names");
    std::error_code error;
    if (fs::is_regular_file(names, error)) {
      auto text = read_file(names, kMostOfData);
      if (!text) return std::move(text).errors();
      input.names[node.program] = std::move(text).value();
    } else if (auto split = bytes ? split_names(*bytes) : std::nullopt) {  // a channel's program
      bytes = std::move(split->program);
      if (!split->names.empty()) input.names[node.program] = std::move(split->names);
    }
    if (bytes && standard) {
      bytes = with_standard_exceptions(*bytes, request.executable, workspace.built.settings.cache,
                                       cancellation);
    }
    if (!bytes) return std::move(bytes).errors();
    input.programs[node.program] = std::move(bytes).value();
  }
  return Done{};
}

}  // namespace ros2wasm
