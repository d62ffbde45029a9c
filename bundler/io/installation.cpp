// See installation.hpp.
#include "bundler/io/installation.hpp"

#include <vector>

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

std::vector<fs::path> data_folders(const fs::path& executable) {
  const fs::path folder = executable.parent_path();
  return {folder, folder.parent_path() / "share" / "ros2wasm"};
}

}  // namespace

Outcome<fs::path> find_own_data(const fs::path& executable, std::string_view relative,
                                std::string_view what) {
  std::error_code error;
  std::vector<std::string> looked;
  for (const fs::path& folder : data_folders(executable)) {
    const fs::path candidate = folder / relative;
    if (fs::exists(candidate, error)) return candidate.lexically_normal();
    looked.push_back("it is not at " + candidate.lexically_normal().string());
  }
  return Diagnostic{.code = "R2W0912",
                    .kind = FailureKind::kEnvironment,
                    .message = "this installation of ros2wasm is not complete: " +
                               std::string(what) + " is missing",
                    .why = std::move(looked)};
}

std::optional<fs::path> find_npm_tool(const fs::path& executable, std::string_view name) {
  std::error_code error;
  std::vector<fs::path> places = data_folders(executable);
  places.push_back(executable.parent_path().parent_path());
  for (const fs::path& place : places) {
    const fs::path candidate = place / "node_modules" / ".bin" / name;
    if (fs::exists(candidate, error)) return candidate.lexically_normal();
  }
  return std::nullopt;
}

}  // namespace ros2wasm
