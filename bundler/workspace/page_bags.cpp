// See page_bags.hpp.
#include "bundler/workspace/page_bags.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include "bundler/io/files.hpp"
#include "bundler/workspace/page_file.hpp"
#include "bundler/workspace/page_text.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr std::uintmax_t kMostBytes = std::uintmax_t{512} << 20;
constexpr std::string_view kMagic{"\x89MCAP0\r\n", 8};

}  // namespace

Outcome<std::vector<PageFile>> read_page_bags(const fs::path& folder,
                                              const std::vector<Spanned<std::string>>& bags) {
  std::vector<PageFile> files;
  Diagnostics problems;
  std::uintmax_t size = 0;
  const auto take = [&](const Spanned<std::string>& bag) -> std::optional<Diagnostic> {
    const std::string path = fs::path(bag.value).lexically_normal().generic_string();
    if (leaves_folder(path)) return page_file_refused(bag, path, kNotInFolder);
    const std::string name = fs::path(path).filename().string();
    const bool comes_twice = std::any_of(files.begin(), files.end(), [&](const PageFile& one) {
      return fs::path(one.path).filename() == name;
    });
    if (comes_twice)
      return page_file_refused(bag, path, "another bag has the name `" + name + "` already");
    const auto real = find_page_file(folder, bag, path);
    if (!real) return real.errors().front();
    std::error_code error;
    size += fs::file_size(*real, error);
    if (error || size > kMostBytes)
      return page_file_refused(bag, path, "the bags have more than 512 MiB together");
    auto bytes = read_file(*real, kMostOfData);
    if (!bytes) return bytes.errors().front();
    if (!std::string_view(*bytes).starts_with(kMagic))
      return page_file_refused(bag, path, "it is not an MCAP file, which is what the page plays");
    files.push_back({.path = path, .bytes = std::move(*bytes)});
    return std::nullopt;
  };
  for (const Spanned<std::string>& bag : bags)
    if (auto problem = take(bag)) problems.push_back(*std::move(problem));
  if (!problems.empty()) return problems;
  return files;
}

Diagnostics cut_bags(const std::vector<PageFile>& files,
                     const std::vector<Spanned<std::string>>& bags) {
  Diagnostics warnings;
  for (std::size_t i = 0; i < files.size() && i < bags.size(); ++i) {
    const std::string_view bytes = files[i].bytes;
    if (bytes.size() > kMagic.size() && bytes.ends_with(kMagic)) continue;
    warnings.push_back(
        {.code = "R2W0118",
         .severity = Severity::kWarning,
         .message = "the bag `" + files[i].path + "` is not whole",
         .span = bags[i].span,
         .why = {"it does not end with the sign of MCAP files, so its end is missing",
                 "the page plays what is there"}});
  }
  return warnings;
}

Outcome<PageFiles> read_page_files(const fs::path& folder, const Manifest& manifest) {
  PageFiles files;
  Diagnostics problems;
  if (manifest.ui_text) {
    auto text = read_page_text(folder, *manifest.ui_text);
    if (text) files.text = std::move(*text);
    if (!text) append(problems, text.errors());
  }
  auto images = read_task_images(folder, manifest.tasks);
  if (!images) {
    append(problems, images.errors());
  } else {
    for (PageFile& image : *images) {
      const bool known = std::any_of(files.text.begin(), files.text.end(),
                                     [&](const PageFile& one) { return one.path == image.path; });
      if (!known) files.text.push_back(std::move(image));
    }
  }
  auto bags = read_page_bags(folder, manifest.ui_bags);
  if (bags) files.bags = std::move(*bags);
  if (!bags) append(problems, bags.errors());
  if (!problems.empty()) return problems;
  return files;
}

}  // namespace ros2wasm
