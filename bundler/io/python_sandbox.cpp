// See python_sandbox.hpp.
#include "bundler/io/python_sandbox.hpp"

#include <set>

namespace ros2wasm {

ProcessRequest python_sandbox(const std::filesystem::path& node_js,
                              const std::vector<std::filesystem::path>& folders,
                              const std::vector<std::string>& program) {
  ProcessRequest request{
      .arguments = {node_js.string(), "--permission", "--disallow-code-generation-from-strings"},
      .environment = {},
      .directory = {},
      .output_mode = OutputMode::kCapture,
      .on_output = {},
      .is_confined = true};
  // In this order: Node.js denies a folder that is permitted after one that lies in it.
  const std::set<std::filesystem::path> parents_first(folders.begin(), folders.end());
  for (const std::filesystem::path& folder : parents_first)
    request.arguments.push_back("--allow-fs-read=" + folder.string());
  request.arguments.insert(request.arguments.end(), program.begin(), program.end());
  return request;
}

}  // namespace ros2wasm
