// See site_path.hpp.
#include "bundler/site/site_path.hpp"

#include <algorithm>
#include <filesystem>

namespace ros2wasm {
namespace fs = std::filesystem;

std::optional<Diagnostic> refuse_site_path(const std::string& path) {
  const fs::path planned(path);
  const bool inside =
      planned.is_relative() && planned.has_filename() && path.find('\0') == std::string::npos &&
      std::none_of(planned.begin(), planned.end(),
                   [](const fs::path& part) { return part == ".." || part == "."; });
  if (inside) return std::nullopt;
  return Diagnostic{.code = "R2W0608",
                    .message = "`" + path + "` is a file of the site that is not inside it",
                    .why = {"a name that came with a package or a lock leads out of its folder"},
                    .fix = {"take the package from a channel that you trust"}};
}

}  // namespace ros2wasm
