// See page_file.hpp.
#include "bundler/workspace/page_file.hpp"

#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;

Diagnostic page_file_refused(const Spanned<std::string>& file, const std::string& path,
                             std::string why) {
  return Diagnostic{.code = "R2W0118",
                    .message = "`" + path + "` cannot be part of the page",
                    .span = file.span,
                    .label = path == file.value ? "" : "named in this file",
                    .why = {std::move(why)}};
}

bool leaves_folder(const std::string& path) {
  const fs::path clean(path);
  return clean.is_absolute() || path.empty() || *clean.begin() == "..";
}

Outcome<fs::path> find_page_file(const fs::path& folder, const Spanned<std::string>& file,
                                 const std::string& path) {
  const auto real = path_within(folder, folder / path);
  std::error_code error;
  if (real && fs::is_regular_file(*real, error)) return *real;
  return Diagnostics{
      page_file_refused(file, path,
                        fs::exists(folder / path, error)
                            ? "it is a link out of the folder of the manifest, or no file"
                            : "there is no such file in the folder of the manifest")};
}

}  // namespace ros2wasm
