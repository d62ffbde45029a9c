// See size_budget.hpp.
#include "bundler/plan/size_budget.hpp"

#include <algorithm>
#include <charconv>
#include <span>
#include <vector>

#include "bundler/archive/deflate.hpp"
#include "workspace_schema/base/byte_size.hpp"

namespace ros2wasm {
namespace {

constexpr std::size_t kShownParts = 12;
constexpr std::uint64_t kGzipFrame = 18;  // bytes around what deflate gives

bool is_loaded(const PlannedFile& file) {
  return !file.path.ends_with(".names");
}

std::string part_of(const PlannedFile& file) {
  const std::size_t slash = file.path.find('/');
  if (slash == std::string::npos) return file.reason.starts_with("runtime ") ? "runtime" : "lists";
  const std::string folder = file.path.substr(0, slash);
  if (folder == "share") return "package " + package_of_shared(file.path);
  if (folder != "programs") return folder;
  const std::size_t end = file.path.find('/', slash + 1);
  return "package " + file.path.substr(slash + 1, end - slash - 1);
}

std::string cell(std::string text) {
  if (text.size() < 11) text.insert(0, 11 - text.size(), ' ');
  return text;
}

std::uint64_t size_in(const PartSizes& sizes, const std::string& part) {
  const auto found = sizes.find(part);
  return found == sizes.end() ? 0 : found->second;
}

/// The parts that are larger than `before`, the largest growth first, one a line; each line begins
/// with a newline.
std::string table(const PartSizes& now, const PartSizes& before) {
  struct Row {
    std::string part;
    std::uint64_t was;
    std::uint64_t is;
  };
  std::vector<Row> rows;
  for (const auto& [part, size] : now) {
    if (const std::uint64_t was = size_in(before, part); size > was)
      rows.push_back({part, was, size});
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.is - a.was > b.is - b.was; });
  std::string lines;
  const std::size_t shown = std::min(rows.size(), kShownParts);
  for (const Row& row : std::span(rows).first(shown)) {
    lines += "\n";
    if (!before.empty()) lines += cell(std::to_string(row.was));
    lines += cell(std::to_string(row.is));
    if (!before.empty()) lines += cell("+" + std::to_string(row.is - row.was));
    lines += "  " + row.part;
  }
  if (shown < rows.size()) lines += "\nand " + std::to_string(rows.size() - shown) + " more";
  return lines;
}

}  // namespace

PartSizes part_sizes(const SitePlan& plan) {
  PartSizes sizes;
  for (const PlannedFile& file : plan.files) {
    if (is_loaded(file)) sizes[part_of(file)] += file.bytes.size();
  }
  return sizes;
}

std::uint64_t compressed_size(const SitePlan& plan) {
  std::uint64_t sum = 0;
  for (const PlannedFile& file : plan.files) {
    if (is_loaded(file)) sum += deflated(file.bytes).size() + kGzipFrame;
  }
  return sum;
}

std::string sizes_text(const PartSizes& sizes) {
  std::string text =
      "# Bytes of the site's parts. `ros2wasm pack` writes them, and compares with them when the\n"
      "# site is over `site: budget:` of the manifest. Keep this file with the lock.\n";
  for (const auto& [part, size] : sizes) text += part + ": " + std::to_string(size) + "\n";
  return text;
}

PartSizes read_sizes(std::string_view text) {
  PartSizes sizes;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const std::size_t colon = line.rfind(": ");
    if (line.starts_with('#') || colon == std::string_view::npos) continue;
    std::uint64_t size = 0;
    const char* end = line.data() + line.size();
    const auto [stop, fault] = std::from_chars(line.data() + colon + 2, end, size);
    if (fault == std::errc() && stop == end) sizes[std::string(line.substr(0, colon))] = size;
  }
  return sizes;
}

std::optional<Diagnostic> over_budget(const SiteBudget& budget, const SitePlan& plan,
                                      const std::optional<PartSizes>& before) {
  const auto fault = [&](const Spanned<std::uint64_t>& most, std::uint64_t size,
                         const std::string& kind) {
    Diagnostic error{.code = "R2W0660",
                     .message = "the site has " + byte_size_text(size) + kind + ", " +
                                byte_size_text(size - most.value) + " more than its budget",
                     .span = most.span,
                     .label = std::to_string(size) + " bytes are over this"};
    const PartSizes now = part_sizes(plan);
    if (before && !before->empty()) {
      const std::string grown = table(now, *before);
      error.why.push_back(grown.empty()
                              ? "nothing grew since ros2wasm.sizes was written: the budget is new"
                              : "what grew since ros2wasm.sizes was written, in bytes (was, is):" +
                                    grown);
    } else {
      error.why.push_back("there is no ros2wasm.sizes to compare with; its parts, in bytes:" +
                          table(now, {}));
    }
    return error;
  };
  if (budget.total) {
    const std::uint64_t size = total_size(plan) - names_size(plan);
    if (size > budget.total->value) return fault(*budget.total, size, "");
  }
  if (budget.compressed) {
    const std::uint64_t size = compressed_size(plan);
    if (size > budget.compressed->value) return fault(*budget.compressed, size, " compressed");
  }
  return std::nullopt;
}

}  // namespace ros2wasm
