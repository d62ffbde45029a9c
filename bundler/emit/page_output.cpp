// See page_output.hpp.
#include "bundler/emit/page_output.hpp"

#include "bundler/io/files.hpp"
#include "bundler/render/carried_page.hpp"
#include "bundler/site/own_site.hpp"
#include "bundler/site/site_path.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// Browsers hold the page as one text, of half a gigabyte at most.
constexpr std::uint64_t kMostBytes = 300'000'000;

Diagnostic too_large(const fs::path& file, std::string why) {
  return Diagnostic{.code = "R2W0609",
                    .message = "the site does not fit into the page `" + file.string() + "`",
                    .why = {std::move(why)},
                    .fix = {"write it as a folder, or with a name that ends in .zip"}};
}

}  // namespace

std::optional<Diagnostic> refuse_page(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status) && !fs::is_symlink(fs::symlink_status(file, error))) return std::nullopt;
  if (fs::is_regular_file(status) && is_site_page_of_ours(file)) return std::nullopt;
  return Diagnostic{
      .code = "R2W0601",
      .message = "`" + file.string() + "` exists and is not a site made by ros2wasm",
      .why = {fs::is_regular_file(status)
                  ? "writing a site there would remove it; it is not a page that carries a site"
                  : "it is not a file, and a name that ends in .html asks for one page"},
      .fix = {"choose another place with -o"}};
}

Outcome<Done> emit_page(const SitePlan& plan, const fs::path& file,
                        const Cancellation& cancellation) {
  if (auto refusal = refuse_page(file)) return *refusal;
  if (!plan.channel.empty())
    return too_large(file, "--with-channel asks for a channel beside it, which no page loads");
  if (const std::uint64_t size = total_size(plan); size > kMostBytes)
    return too_large(file, "it has " + std::to_string(size) + " bytes");
  for (const PlannedFile& one : plan.files) {
    if (auto refusal = refuse_site_path(one.path)) return *refusal;
  }
  if (cancellation.requested()) return interrupted();
  return write_file(file, carried_page(plan));
}

}  // namespace ros2wasm
